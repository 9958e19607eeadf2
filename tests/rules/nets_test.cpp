// Nets as rules: their tables.

#include <gtest/gtest.h>

#include "rules/built_in/naccache_shinghal.hpp"
#include "rules/rule_table.hpp"
#include "rules/trained_cluster.hpp"
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

}  // namespace
}  // namespace thinbench
