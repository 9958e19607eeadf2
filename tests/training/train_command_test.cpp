#include "training/train_command.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "training/weights_file.hpp"

namespace thinbench {
namespace {

struct Ran {
  std::string out;
  std::string err;
};

Ran run(const std::string& line) {
  CLI::App program("thinbench");
  std::ostringstream out;
  std::ostringstream err;
  add_train_command(program, out, err);
  program.parse(line);
  return {out.str(), err.str()};
}

std::string content(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(TrainCommand, two_layer_says_epochs_and_restarts_and_writes_both_files) {
  const std::string json = testing::TempDir() + "trained_two_layer.json";
  const std::string markdown = testing::TempDir() + "trained_two_layer.md";
  const Ran ran = run("train two-layer --seed 2 --out " + json + " --markdown " + markdown);
  EXPECT_EQ(ran.out.find("Right on 256 of 256 descriptors with the sigmoid and 256 with the linear "
                         "threshold, after 289 epochs and 0 restarts"),
            0U);
  const auto weights = std::get<TwoLayerWeights>(read_weights(json));
  EXPECT_EQ(table_markdown(weights), content(markdown));
  EXPECT_NE(content(json).find("\"made_by\": \"thinbench train two-layer --seed 2\""),
            std::string::npos);
}

TEST(TrainCommand, two_layer_that_fails_says_how_far_it_came) {
  try {
    (void)run("train two-layer --hidden 1 --max-restarts 0");
    FAIL() << "one hidden neuron was enough";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("of 256 descriptors in 2000 epochs"),
              std::string::npos);
  }
}

TEST(TrainCommand, other_sizes_are_not_written_as_weights) {
  EXPECT_THROW((void)run("train two-layer --hidden 10 --out x.json"), std::invalid_argument);
}

TEST(TrainCommand, cluster_writes_weights_and_header_with_their_commands) {
  const std::string json = testing::TempDir() + "trained_cluster.json";
  const std::string header = testing::TempDir() + "trained_cluster.hpp";
  const Ran ran = run("train cluster --integer --out " + json + " --header " + header);
  EXPECT_EQ(ran.out.find("12 nets, right on all 256 descriptors"), 0U);
  EXPECT_NE(ran.out.find("5 + 52 + 65 = 17 + 37 + 68"), std::string::npos);
  EXPECT_EQ(std::get<ClusterWeights>(read_weights(json)).count, 12);
  EXPECT_NE(content(header).find("thinbench train cluster --integer --header " + header + "\n"),
            std::string::npos);
}

TEST(TrainCommand, cluster_refuses_fewer_nets_than_it_takes) {
  EXPECT_THROW((void)run("train cluster --max-nets 11"), std::runtime_error);
  EXPECT_THROW((void)run("train cluster --max-nets 0"), CLI::ValidationError);
}

TEST(TrainCommand, help_of_each_command_shows_examples) {
  for (const char* line : {"train --help", "train two-layer --help", "train cluster --help"}) {
    CLI::App program("thinbench");
    std::ostringstream stream;
    add_train_command(program, stream, stream);
    EXPECT_THROW(program.parse(line), CLI::CallForHelp);
    EXPECT_NE(program.help().find("Examples:\n  thinbench train"), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace thinbench
