#include "experiments/experiment_command.hpp"

#include <fstream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace thinbench {
namespace {

std::string run(const std::string& line) {
  CLI::App program("thinbench");
  std::ostringstream out;
  std::ostringstream err;
  add_experiment_command(program, out, err);
  program.parse(line);
  return out.str();
}

TEST(ExperimentCommand, prints_a_table_and_writes_the_data) {
  const std::string path = testing::TempDir() + "quantisation.json";
  const std::string table = run("experiment quantisation --out " + path);
  EXPECT_NE(table.find("| rounded | 0 | 251 | 252 | 20 |"), std::string::npos);
  std::ifstream file(path);
  EXPECT_EQ(nlohmann::json::parse(file).at("experiment"), "quantisation");
}

TEST(ExperimentCommand, every_quick_experiment_prints_a_table) {
  for (const char* name : {"operation-counts", "table-2"}) {
    EXPECT_NE(run(std::string("experiment ") + name).find("| --- |"), std::string::npos) << name;
  }
}

TEST(ExperimentCommand, unknown_experiments_and_unwritable_files_are_refused) {
  EXPECT_THROW((void)run("experiment nothing"), CLI::ParseError);
  EXPECT_THROW((void)run("experiment"), CLI::RequiredError);
  EXPECT_THROW((void)run("experiment table-2 --out /no/such/folder/x.json"), std::runtime_error);
}

TEST(ExperimentCommand, help_shows_examples) {
  CLI::App program("thinbench");
  std::ostringstream stream;
  add_experiment_command(program, stream, stream);
  EXPECT_THROW(program.parse("experiment table-2 --help"), CLI::CallForHelp);
  EXPECT_NE(program.help().find("thinbench experiment table-2 --out"), std::string::npos);
}

}  // namespace
}  // namespace thinbench
