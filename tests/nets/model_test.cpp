// Nets as engines see them: what is derived from weights, and that any weights at all can be run.
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "nets/follow_weights.hpp"
#include "nets/trained_cluster.hpp"
#include "nets/variants.hpp"
#include "support/rejection.hpp"
#include "thinbench/thinning.hpp"
#include "thinning/engines/mux_rule.hpp"
#include "thinning/engines/rule_table.hpp"

namespace thinbench {
namespace {

using detail::default_net;
using detail::kTrainedCluster;
using detail::make_mux_program;
using detail::MuxProgram;

constexpr detail::RuleTable kRule = detail::make_rule_table<detail::NaccacheShinghal, 0>();

TEST(Models, paper_nets_and_trained_cluster_have_the_table_of_the_rule) {
  for (const Rule rule :
       {Rule::net_two_layer_sigmoid, Rule::net_two_layer_linear, Rule::net_single_layer_cluster}) {
    const auto net = default_net(rule);
    for (std::size_t k = 0; k < 512; ++k) EXPECT_EQ(net->new_pixel[k], kRule[k]) << k;
  }
}

TEST(Models, eight_bits_are_enough_for_the_linear_net) {
  EXPECT_TRUE(default_net(Rule::net_two_layer_linear)->fixed_point_is_exact);
}

std::vector<std::uint8_t> random_table(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> table(256);
  for (std::uint8_t& entry : table) entry = random() & 1;
  return table;
}

void expect_evaluates(const std::vector<std::uint8_t>& table) {
  const MuxProgram program = make_mux_program(table.data());
  ASSERT_LE(program.count, MuxProgram::kMaxNodes);
  for (int word = 0; word < 8; ++word) {
    const auto input = [word](int variable) { return detail::counting_pattern(variable, word); };
    const detail::Neighbourhood<std::uint64_t> n = {
        input(8), input(0), input(1), input(2), input(3), input(4), input(5), input(6), input(7)};
    const std::uint64_t next = detail::MuxRule{program}.next<0>(n);
    for (int bit = 0; bit < 64; ++bit) {
      const int code = 64 * word + bit;
      const bool expected = code >= 256 && table[static_cast<std::size_t>(code & 255)] != 0;
      ASSERT_EQ((next >> bit & 1) != 0, expected) << code;
    }
  }
}

TEST(DecisionDiagram, evaluates_any_table) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) expect_evaluates(random_table(seed));
  expect_evaluates(std::vector<std::uint8_t>(256, 0));
  expect_evaluates(std::vector<std::uint8_t>(256, 1));
  expect_evaluates({kRule.begin() + 256, kRule.end()});
}

TEST(DecisionDiagram, rule_of_the_paper_needs_few_nodes) {
  EXPECT_LE(make_mux_program(kRule.data() + 256).count, 40);
}

TwoLayerWeights inexact_in_eight_bits() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.bias = 1e30F;
  return weights;
}

TEST(Models, eight_bits_do_not_express_a_bias_beyond_their_sums) {
  EXPECT_FALSE(two_layer_net(inexact_in_eight_bits(), Activation::linear)->fixed_point_is_exact);
}

TEST(Models, rounded_weights_are_correct_on_251_and_252_descriptors) {
  const auto correct = [&](Activation activation) {
    const auto rounded = two_layer_net(kRoundedTwoLayer, activation);
    int count = 0;
    for (std::size_t k = 256; k < 512; ++k) count += rounded->new_pixel[k] == kRule[k] ? 1 : 0;
    return count;
  };
  EXPECT_EQ(correct(Activation::sigmoid), 251);
  EXPECT_EQ(correct(Activation::linear), 252);
}

/// A net that learned something else: Table 1 with one hidden neuron silenced.
TwoLayerWeights damaged_net() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.weight[0] = 0;
  return weights;
}

TEST(Models, every_variant_follows_other_weights_not_the_known_rule) {
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  ByteImage by_rule(130, 50);
  thin(Rule::naccache_shinghal, image.view(), by_rule.view());
  for (const Activation activation : {Activation::linear, Activation::sigmoid}) {
    const Outcome damaged =
        reference_outcome(damaged_net(), activation, Border::background, image.view());
    EXPECT_FALSE(equal(damaged.image.view(), by_rule.view()));
    expect_every_variant_follows(damaged_net(), activation);
  }
}

/// The trained cluster with one net silenced: it says foreground throughout.
ClusterWeights damaged_cluster() {
  ClusterWeights weights = kTrainedCluster;
  weights.nets[5].neuron = {{}, 1.0F};
  return weights;
}

TEST(Models, every_variant_follows_other_weights_of_a_cluster) {
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

TEST(Models, that_take_weights_out_of_range_are_rejected) {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.hidden[3].weight[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(rejection_of([&] { (void)two_layer_net(weights, Activation::linear); }),
            "weight 5 of hidden neuron 3 is nan; it must be within -1e30 ... 1e30");
  weights = kPaperTwoLayer;
  weights.output.bias = 2e30F;
  EXPECT_THROW((void)two_layer_net(weights, Activation::sigmoid), std::invalid_argument);
}

TEST(Models, of_clusters_that_do_not_cover_the_descriptors_are_rejected) {
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

TEST(MakeState, rejects_eight_bits_for_a_net_that_they_cannot_express) {
  const detail::ThinningOperation& operation = detail::operation_of(Rule::net_two_layer_linear);
  const auto net = two_layer_net(inexact_in_eight_bits(), Activation::linear);
  ASSERT_FALSE(net->fixed_point_is_exact);
  for (const detail::ThinningVariant& variant : operation.variants) {
    if (variant.technique != Technique::simd_fixed_point || !isa_available(variant.isa)) continue;
    EXPECT_EQ(rejection_of([&] { (void)make_state(operation, variant, 5, 5, {.net = net}); }),
              "simd_fixed_point cannot run: no 8-bit weights decide as these do");
  }
}

}  // namespace
}  // namespace thinbench
