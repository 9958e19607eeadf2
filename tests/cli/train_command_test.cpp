#include <gtest/gtest.h>

#include "program_run.hpp"
#include "support/temporary_directory.hpp"
#include "training/weights_file.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

TEST(TrainCommand, two_layer_says_epochs_and_restarts_and_writes_both_files) {
  const TemporaryDirectory folder;
  const std::string json = folder.file("weights.json");
  const std::string markdown = folder.file("weights.md");
  const ProgramRun ran =
      run_with({"train", "two-layer", "--seed", "2", "--out", json, "--markdown", markdown});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.find("Correct on 256 of 256 descriptors with the sigmoid and 256 with the linear "
                         "threshold, after 289 epochs and 0 restarts"),
            0U);
  const auto weights = std::get<TwoLayerWeights>(read_weights(json));
  EXPECT_EQ(table_markdown(weights), bytes_of(markdown));
  EXPECT_NE(bytes_of(json).find("\"made_by\": \"thinbench train two-layer --seed 2\""),
            std::string::npos);
}

TEST(TrainCommand, two_layer_that_fails_says_how_far_it_came) {
  EXPECT_EQ(failure_of({"train", "two-layer", "--hidden", "1", "--max-restarts", "0"}, 1)
                .find("training reached "),
            0U);
}

TEST(TrainCommand, cluster_writes_weights_and_header_with_their_commands) {
  const TemporaryDirectory folder;
  const std::string json = folder.file("cluster.json");
  const std::string header = folder.file("cluster.hpp");
  const ProgramRun ran =
      run_with({"train", "cluster", "--integer", "--out", json, "--header", header});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out.find("12 nets, correct on all 256 descriptors"), 0U);
  EXPECT_NE(ran.out.find("5 + 52 + 65 = 17 + 37 + 68"), std::string::npos);
  EXPECT_EQ(std::get<ClusterWeights>(read_weights(json)).count, 12);
  EXPECT_NE(bytes_of(header).find("thinbench train cluster --integer --header " + header + "\n"),
            std::string::npos);
}

TEST(TrainCommand, cluster_refuses_fewer_nets_than_it_takes) {
  EXPECT_EQ(failure_of({"train", "cluster", "--max-nets", "11"}, 1),
            "the rule needs 12 nets; --max-nets allows 11");
  EXPECT_EQ(
      failure_of({"train", "cluster", "--max-nets", "0"}, 2),
      "--max-nets: expected an integer in [1, 16], got '0'; see 'thinbench train cluster --help'");
}

TEST(TrainCommand, numbers_that_are_none_are_refused) {
  const std::string see = "; see 'thinbench train two-layer --help'";
  for (const std::string seed : {"-1", "1.5", "x", ""}) {
    EXPECT_EQ(failure_of({"train", "two-layer", "--seed", seed}, 2),
              "--seed: expected an integer in [0, 18446744073709551615], got '" + seed + "'" + see);
  }
  EXPECT_EQ(failure_of({"train", "two-layer", "--hidden", "65"}, 2),
            "--hidden: expected an integer in [1, 64], got '65'" + see);
}

TEST(TrainCommand, other_sizes_are_not_written_as_weights) {
  const TemporaryDirectory folder;
  EXPECT_EQ(failure_of({"train", "two-layer", "--hidden", "10", "--out", folder.file("a.json")}, 2),
            "--out: weights files hold nets of 8 hidden neurons, not 10");
  EXPECT_EQ(folder.names(), Names{});
}

TEST(TrainCommand, files_that_cannot_be_written_are_refused_before_the_training) {
  const std::string reason = "': there is no directory 'no_such_folder'";
  for (const std::string option : {"--out", "--header"}) {
    EXPECT_EQ(failure_of({"train", "cluster", option, "no_such_folder/a"}, 1),
              "cannot write 'no_such_folder/a" + reason);
  }
  // With these options the training itself would fail, with other words.
  for (const std::string option : {"--out", "--markdown"}) {
    EXPECT_EQ(failure_of({"train", "two-layer", "--seed", "5", "--max-restarts", "0", option,
                          "no_such_folder/a"},
                         1),
              "cannot write 'no_such_folder/a" + reason);
  }
}

}  // namespace
}  // namespace thinbench
