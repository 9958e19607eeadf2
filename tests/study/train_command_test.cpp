#include <gtest/gtest.h>

#include "program_run.hpp"
#include "rules/weights_file.hpp"
#include "support/temporary_directory.hpp"
#include "training/weights_text.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

TEST(TrainCommand, two_layer_prints_epochs_and_restarts_and_writes_both_files) {
  const TemporaryDirectory directory;
  const std::string json = directory.file("weights.json");
  const std::string markdown = directory.file("weights.md");
  const ProgramRun ran =
      run_with({"train", "two-layer", "--seed", "2", "--out", json, "--markdown", markdown});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(
      ran.out.find("Correct on 256 of 256 descriptors with the sigmoid and 256 with the linear "
                   "threshold, after 289 epochs and 0 restarts"),
      0U);
  const auto weights = std::get<TwoLayerWeights>(read_weights(json));
  EXPECT_EQ(table_markdown(weights), bytes_of(markdown));
  EXPECT_NE(bytes_of(json).find("\"made_by\": \"thinbench-study train two-layer --seed 2\""),
            std::string::npos);
}

TEST(TrainCommand, failed_two_layer_training_prints_its_best_result) {
  EXPECT_EQ(failure_of({"train", "two-layer", "--hidden", "1", "--max-restarts", "0"}, 1)
                .find("training reached "),
            0U);
}

TEST(TrainCommand, cluster_writes_weights_and_header_with_their_commands) {
  const TemporaryDirectory directory;
  const std::string json = directory.file("cluster.json");
  const std::string header = directory.file("cluster.hpp");
  const ProgramRun ran =
      run_with({"train", "cluster", "--integer", "--out", json, "--header", header});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.find("12 nets, correct on all 256 descriptors"), 0U);
  EXPECT_NE(ran.out.find("5 + 52 + 65 = 17 + 37 + 68"), std::string::npos);
  EXPECT_EQ(std::get<ClusterWeights>(read_weights(json)).count, 12);
  EXPECT_NE(
      bytes_of(header).find("thinbench-study train cluster --integer --header " + header + "\n"),
      std::string::npos);
}

TEST(TrainCommand, cluster_rejects_a_limit_below_the_minimum_number_of_nets) {
  EXPECT_EQ(failure_of({"train", "cluster", "--max-nets", "11"}, 1),
            "the rule needs 12 nets; --max-nets allows 11");
  EXPECT_EQ(failure_of({"train", "cluster", "--max-nets", "0"}, 2),
            "--max-nets: expected an integer in [1, 16], got '0'; see 'thinbench-study train "
            "cluster --help'");
}

TEST(TrainCommand, invalid_numbers_are_rejected) {
  const std::string see = "; see 'thinbench-study train two-layer --help'";
  for (const std::string seed : {"-1", "1.5", "x", ""}) {
    EXPECT_EQ(failure_of({"train", "two-layer", "--seed", seed}, 2),
              "--seed: expected an integer in [0, 18446744073709551615], got '" + seed + "'" + see);
  }
  EXPECT_EQ(failure_of({"train", "two-layer", "--hidden", "65"}, 2),
            "--hidden: expected an integer in [1, 64], got '65'" + see);
}

TEST(TrainCommand, weights_files_for_other_sizes_are_rejected) {
  const TemporaryDirectory directory;
  EXPECT_EQ(
      failure_of({"train", "two-layer", "--hidden", "10", "--out", directory.file("a.json")}, 2),
      "--out: weights files hold nets of 8 hidden neurons, not 10");
  EXPECT_EQ(directory.names(), Names{});
}

TEST(TrainCommand, unwritable_files_are_rejected_before_the_training) {
  const std::string reason = "': there is no directory 'no_such_directory'";
  for (const std::string option : {"--out", "--header"}) {
    EXPECT_EQ(failure_of({"train", "cluster", option, "no_such_directory/a"}, 1),
              "cannot write 'no_such_directory/a" + reason);
  }
  // With these options the training itself would fail with another error.
  for (const std::string option : {"--out", "--markdown"}) {
    EXPECT_EQ(failure_of({"train", "two-layer", "--seed", "5", "--max-restarts", "0", option,
                          "no_such_directory/a"},
                         1),
              "cannot write 'no_such_directory/a" + reason);
  }
}

}  // namespace
}  // namespace thinbench
