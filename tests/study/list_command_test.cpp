#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/thread_team.hpp"
#include "peers/peers.hpp"
#include "program_run.hpp"
#include "support/variant_of.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

/// Borders and limits are no operations of their own.
std::vector<Operation> listed() {
  std::vector<Operation> operations = operations_with_peers();
  std::erase_if(operations, [](const Operation& one) {
    return one.border == Border::keep || one.max_iterations.has_value();
  });
  return operations;
}

std::size_t catalogue_size() {
  std::size_t rows = 0;
  for (const Operation& operation : listed()) rows += operation.variants.size();
  return rows;
}

/// The lines of `list` after its head.
std::vector<std::string> listed_operations() {
  std::istringstream lines(run_with({"list"}).out);
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);) found.push_back(line);
  found.erase(found.begin());
  return found;
}

TEST(ListCommand, prints_a_line_for_each_operation) {
  const std::vector<std::string> lines = listed_operations();
  const std::vector<Operation> operations = listed();
  ASSERT_EQ(lines.size(), operations.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::regex pattern(operations[i].name + R"( +[1-9]\d* +\w+/[\w.]+ +\S.*)");
    EXPECT_TRUE(std::regex_match(lines[i], pattern)) << lines[i];
    EXPECT_NE(lines[i].find(operations[i].description), std::string::npos) << lines[i];
  }
}

TEST(ListCommand, counts_the_librarys_variants_that_run_here_and_names_what_the_library_takes) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  int listed = 0;
  for (const std::string& line : listed_operations()) {
    std::istringstream words(line);
    std::string operation;
    std::string variants;
    std::string fastest;
    words >> operation >> variants >> fastest;
    if (operation == "fill_holes") {
      EXPECT_EQ(variants, "2") << "with its one peer 3";
    }
    if (operation != "thin_guo_hall") continue;
    const auto& chosen = chosen_variant(Rule::guo_hall, 1024, 9);
    EXPECT_EQ(fastest, std::string(chosen.technique) + "/baseline");
    ++listed;
  }
  EXPECT_EQ(listed, 1);
}

TEST(ListCommand, variants_are_an_aligned_line_for_every_row) {
  const ProgramRun run = run_with({"list", "--variants"});
  EXPECT_EQ(run.status, 0);
  std::istringstream lines(run.out);
  std::string header;
  std::getline(lines, header);
  const std::size_t column = header.find("available");
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line) && !line.empty(); ++rows) {
    const std::string cell = line.substr(column);
    EXPECT_TRUE(cell == "yes" || cell.rfind("no: ", 0) == 0) << line;
  }
  EXPECT_EQ(rows, catalogue_size());
}

TEST(ListCommand, json_says_why_a_row_is_not_available) {
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const ProgramRun run = run_with({"list", "--json"});
  EXPECT_EQ(run.status, 0);
  const Json list = Json::parse(run.out);
  EXPECT_EQ(list.size(), catalogue_size());
  for (const Json& row : list) {
    EXPECT_TRUE(!row["fastest"] || (row["available"] && !row["peer"] && row["threads"] == "1"));
    EXPECT_LE(row["min_pixels"], row["threads"] == "n" ? detail::kMinPixelsForThreads : 0);
    EXPECT_EQ(row["available"], row["isa"] == "baseline" || row["peer"]);
    EXPECT_EQ(row["available"], row["reason"] == "");
  }
}

}  // namespace
}  // namespace thinbench
