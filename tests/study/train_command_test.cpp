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

}  // namespace
}  // namespace thinbench
