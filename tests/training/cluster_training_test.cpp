#include <utility>

#include <gtest/gtest.h>

#include "support/temporary_directory.hpp"
#include "training/cluster.hpp"

namespace thinbench {
namespace {

const std::vector<TrainedRun>& trained(bool small_integers) {
  static const std::vector<TrainedRun> plain = train_cluster(keep_table_of_rule(), {});
  static const std::vector<TrainedRun> small =
      train_cluster(keep_table_of_rule(), {kMaxClusterNets, true});
  return small_integers ? small : plain;
}

TEST(ClusterTraining, greedy_cut_gives_exactly_the_twelve_runs) {
  // Found by linear programming in floating point, before this code.
  const std::vector<std::pair<int, int>> expected = {
      {0, 67},    {68, 84},   {85, 89},   {90, 96},   {97, 116},  {117, 121},
      {122, 132}, {133, 207}, {208, 212}, {213, 224}, {225, 244}, {245, 255}};
  std::vector<std::pair<int, int>> found;
  for (const TrainedRun& run : trained(false)) found.emplace_back(run.run.first, run.run.last);
  EXPECT_EQ(found, expected);
}

TEST(ClusterTraining, every_run_is_learned_and_one_more_descriptor_is_impossible) {
  const KeepTable rule = keep_table_of_rule();
  for (const TrainedRun& run : trained(false)) {
    const auto [first, last] = run.run;
    EXPECT_TRUE(recognises(run.neuron, rule, run.run)) << first;
    if (last == kDescriptors - 1) continue;
    EXPECT_TRUE(shows_inseparable(run.one_more, rule, {first, last + 1})) << first;
  }
}

TEST(ClusterTraining, weights_decide_as_the_rule) {
  for (const bool small_integers : {false, true}) {
    const Rule net = Rule::from_net(cluster_weights(trained(small_integers)));
    const Rule rule = Rule::naccache_shinghal;
    EXPECT_EQ(net.sub_iterations().front(), rule.sub_iterations().front());
  }
}

TEST(ClusterTraining, the_committed_header_is_what_training_makes) {
  const std::string committed = bytes_of(THINBENCH_SOURCE_DIR "/kernels/rules/trained_cluster.hpp");
  const std::string made = cluster_header(
      cluster_weights(trained(true)),
      "thinbench-study train cluster --integer --header kernels/rules/trained_cluster.hpp");
  EXPECT_EQ(made, committed);
}

}  // namespace
}  // namespace thinbench
