// Nets as rules: their tables and rejected weights.
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "rules/built_in/naccache_shinghal.hpp"
#include "rules/rule_table.hpp"
#include "rules/trained_cluster.hpp"
#include "support/rejection.hpp"
#include "techniques/net_model.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {
namespace {

using detail::kTrainedCluster;

WindowTable table_of(const Rule& rule) {
  EXPECT_EQ(rule.sub_iterations().size(), 1U);
  return rule.sub_iterations().front();
}

TEST(Nets, of_the_paper_and_the_trained_cluster_have_the_table_of_the_rule) {
  const WindowTable table = detail::make_window_table_of<detail::NaccacheShinghal, 0>();
  for (const char* name :
       {"net_two_layer_sigmoid", "net_two_layer_linear", "net_single_layer_cluster"}) {
    EXPECT_EQ(table_of(Rule::named(name)), table) << name;
  }
}

TEST(Nets, with_the_weights_of_a_named_one_have_its_table) {
  for (const Activation activation : {Activation::sigmoid, Activation::linear}) {
    EXPECT_EQ(table_of(Rule::from_net(kPaperTwoLayer, activation)),
              table_of(Rule::named("net_two_layer_linear")));
  }
  EXPECT_EQ(table_of(Rule::from_net(kTrainedCluster)),
            table_of(Rule::named("net_single_layer_cluster")));
}

/// Of the 256 windows of a foreground pixel, those with the decision of the rule.
int correct_descriptors(const TwoLayerWeights& weights, Activation activation) {
  const WindowTable net = table_of(Rule::from_net(weights, activation));
  const WindowTable rule = table_of(Rule::naccache_shinghal);
  int count = 0;
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    const bool is_foreground = (window >> WindowTable::kCentre & 1) != 0;
    count += is_foreground && net[window] == rule[window] ? 1 : 0;
  }
  return count;
}

TEST(Nets, rounded_weights_are_correct_on_251_descriptors_with_sigmoid_and_252_with_linear) {
  EXPECT_EQ(correct_descriptors(detail::kRoundedTwoLayer, Activation::sigmoid), 251);
  EXPECT_EQ(correct_descriptors(detail::kRoundedTwoLayer, Activation::linear), 252);
}

TEST(Nets, reject_weights_out_of_range) {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.hidden[3].weight[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(rejection_of([&] { (void)Rule::from_net(weights, Activation::linear); }),
            "weight 5 of hidden neuron 3: expected a number in [-1e30, 1e30], got nan");
  weights = kPaperTwoLayer;
  weights.output.bias = 2e30F;
  EXPECT_THROW((void)Rule::from_net(weights, Activation::sigmoid), std::invalid_argument);
}

TEST(Nets, reject_an_invalid_activation) {
  EXPECT_EQ(rejection_of([] { (void)Rule::from_net(kPaperTwoLayer, static_cast<Activation>(7)); }),
            "activation: expected sigmoid or linear, got number 7");
}

TEST(Nets, reject_clusters_that_do_not_cover_the_descriptors) {
  ClusterWeights cluster = kTrainedCluster;
  const auto rejection = [&] { return rejection_of([&] { (void)Rule::from_net(cluster); }); };
  cluster.nets[11].last = 254;
  EXPECT_EQ(rejection(), "the nets end at descriptor 254, not 255");
  cluster = kTrainedCluster;
  cluster.nets[3].last = cluster.nets[2].last;
  EXPECT_EQ(rejection(), "net 3 covers no descriptor");
  for (const int count : {0, 17, -1}) {
    cluster.count = count;
    EXPECT_EQ(rejection(),
              "the cluster has " + std::to_string(count) + " nets; it must have 1 to 16");
  }
}

}  // namespace
}  // namespace thinbench
