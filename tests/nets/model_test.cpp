// Net models: what is derived from weights, and that every variant follows any weights.
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "nets/given_weights.hpp"
#include "nets/variants.hpp"
#include "rules/rule_table.hpp"
#include "rules/trained_cluster.hpp"
#include "support/rejection.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using detail::default_net;
using detail::kTrainedCluster;

constexpr detail::RuleTable kRule = detail::make_rule_table<detail::NaccacheShinghal, 0>();

TEST(NetModel, paper_nets_and_trained_cluster_have_the_table_of_the_rule) {
  for (const Rule rule :
       {Rule::net_two_layer_sigmoid, Rule::net_two_layer_linear, Rule::net_single_layer_cluster}) {
    const auto net = default_net(rule);
    for (std::size_t k = 0; k < 512; ++k) EXPECT_EQ(net->new_pixel[k], kRule[k]) << k;
  }
}

TEST(NetModel, eight_bit_weights_are_exact_for_the_paper_s_linear_net) {
  EXPECT_TRUE(default_net(Rule::net_two_layer_linear)->fixed_point_is_exact);
}

TwoLayerWeights inexact_in_eight_bits() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.bias = 1e30F;
  return weights;
}

TEST(NetModel, eight_bit_weights_are_inexact_for_a_huge_bias) {
  EXPECT_FALSE(two_layer_net(inexact_in_eight_bits(), Activation::linear)->fixed_point_is_exact);
}

TEST(NetModel, rounded_weights_are_correct_on_251_descriptors_with_sigmoid_and_252_with_linear) {
  const auto correct = [&](Activation activation) {
    const auto rounded = two_layer_net(kRoundedTwoLayer, activation);
    int count = 0;
    for (std::size_t k = 256; k < 512; ++k) count += rounded->new_pixel[k] == kRule[k] ? 1 : 0;
    return count;
  };
  EXPECT_EQ(correct(Activation::sigmoid), 251);
  EXPECT_EQ(correct(Activation::linear), 252);
}

/// A net with another table than the rule: Table 1 with one hidden neuron disabled.
TwoLayerWeights damaged_net() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.weight[0] = 0;
  return weights;
}

TEST(NetModel, every_variant_follows_weights_that_differ_from_the_rule) {
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  ByteImage by_rule(130, 50);
  thin(Rule::naccache_shinghal, image.view(), by_rule.view());
  for (const Activation activation : {Activation::linear, Activation::sigmoid}) {
    const Outcome damaged =
        reference_outcome(damaged_net(), activation, Border::background, image.view());
    EXPECT_FALSE(equal(damaged.image.view(), by_rule.view()));
    expect_every_variant_equals_reference(damaged_net(), activation);
  }
}

/// The trained cluster with one net replaced by a constant: always foreground.
ClusterWeights damaged_cluster() {
  ClusterWeights weights = kTrainedCluster;
  weights.nets[5].neuron = {{}, 1.0F};
  return weights;
}

TEST(NetModel, every_variant_follows_other_weights_of_a_cluster) {
  const detail::ThinningOperation& operation = detail::operation_of(Rule::net_single_layer_cluster);
  const auto net = cluster_net(damaged_cluster());
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  Outcome expected{ByteImage(130, 50), {}};
  expected.numbers = {reference::net_single_layer_cluster(damaged_cluster(), {Border::keep},
                                                          image.view(), expected.image.view())};
  for (const detail::ThinningVariant& variant : operation.variants) {
    if (!unavailable_reason(variant, 130, Border::keep).empty()) continue;
    const Options options = {.border = Border::keep, .threads = 2, .net = net};
    const auto job = thinning_job(make_state(operation, variant, 130, 50, options));
    EXPECT_EQ(find_mismatch(*job, image.view(), expected).value_or(""), "")
        << technique_name(variant.technique) << " at " << isa_name(variant.isa);
  }
}

TEST(NetModel, rejects_weights_out_of_range) {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.hidden[3].weight[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(rejection_of([&] { (void)two_layer_net(weights, Activation::linear); }),
            "weight 5 of hidden neuron 3: expected a number in [-1e30, 1e30], got nan");
  weights = kPaperTwoLayer;
  weights.output.bias = 2e30F;
  EXPECT_THROW((void)two_layer_net(weights, Activation::sigmoid), std::invalid_argument);
}

TEST(NetModel, rejects_clusters_that_do_not_cover_the_descriptors) {
  ClusterWeights cluster = kTrainedCluster;
  cluster.nets[11].last = 254;
  EXPECT_EQ(rejection_of([&] { (void)cluster_net(cluster); }),
            "the nets end at descriptor 254, not 255");
  cluster = kTrainedCluster;
  cluster.nets[3].last = cluster.nets[2].last;
  EXPECT_EQ(rejection_of([&] { (void)cluster_net(cluster); }), "net 3 covers no descriptor");
  for (const int count : {0, 17, -1}) {
    cluster.count = count;
    EXPECT_EQ(rejection_of([&] { (void)cluster_net(cluster); }),
              "the cluster has " + std::to_string(count) + " nets; it must have 1 to 16");
  }
}

TEST(MakeState, rejects_fixed_point_for_a_net_without_exact_eight_bit_weights) {
  const detail::ThinningOperation& operation = detail::operation_of(Rule::net_two_layer_linear);
  const auto net = two_layer_net(inexact_in_eight_bits(), Activation::linear);
  ASSERT_FALSE(net->fixed_point_is_exact);
  for (const detail::ThinningVariant& variant : operation.variants) {
    if (variant.technique != Technique::simd_fixed_point || !isa_available(variant.isa)) continue;
    EXPECT_EQ(rejection_of([&] { (void)make_state(operation, variant, 5, 5, {.net = net}); }),
              "simd_fixed_point cannot run: no 8-bit weights reproduce the decisions of this net");
  }
}

}  // namespace
}  // namespace thinbench
