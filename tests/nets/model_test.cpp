// Models: what engines derive from weights, and that any rule at all can be run.
#include <random>

#include <gtest/gtest.h>

#include "api/catalogue.hpp"
#include "harness/crosscheck.hpp"
#include "harness/test_images.hpp"
#include "harness/thinning_family.hpp"
#include "nets/decision_diagram.hpp"
#include "nets/make_model.hpp"
#include "nets/mux_rule.hpp"
#include "nets/net_rows.hpp"
#include "nets/trained_cluster.hpp"
#include "reference.hpp"
#include "thinning/rule_table.hpp"
#include "training/two_layer_training.hpp"

namespace thinbench {
namespace {

constexpr RuleTable kRule = make_rule_table<NaccacheShinghal, 0>();

TEST(Models, paper_nets_and_trained_cluster_have_the_table_of_the_rule) {
  for (const RuleModel* model :
       {&paper_sigmoid_model(), &paper_linear_model(), &trained_cluster_model()}) {
    for (std::size_t k = 0; k < 512; ++k) EXPECT_EQ(model->new_pixel[k], kRule[k]) << k;
  }
}

TEST(Models, eight_bits_are_enough_for_the_linear_net) {
  EXPECT_TRUE(paper_linear_model().fixed_point_is_exact);
}

std::vector<std::uint8_t> random_table(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> table(256);
  for (std::uint8_t& entry : table) entry = random() & 1;
  return table;
}

void expect_evaluates(const std::vector<std::uint8_t>& table) {
  const MuxProgram program = make_decision_diagram(table.data());
  ASSERT_LE(program.count, MuxProgram::kMaxNodes);
  for (int word = 0; word < 8; ++word) {
    const auto input = [word](int variable) { return counting_pattern(variable, word); };
    const Neighbourhood<std::uint64_t> n = {input(8), input(0), input(1), input(2), input(3),
                                            input(4), input(5), input(6), input(7)};
    const std::uint64_t next = MuxRule{program}.next<0>(n);
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
  EXPECT_LE(make_decision_diagram(kRule.data() + 256).count, 40);
}

/// A net that learned something else: Table 1 with one hidden neuron silenced.
TwoLayerWeights damaged_net() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.weight[0] = 0;
  return weights;
}

/// What the reference makes of an image with these weights.
Outcome reference_outcome(const TwoLayerWeights& weights, Activation activation,
                          const ConstImageView& image) {
  Outcome outcome{ByteImage(image.width, image.height), {}};
  outcome.numbers = {
      reference::net_two_layer(weights, activation, 1000, image, outcome.image.view())};
  return outcome;
}

/// Compares every variant that runs here, given these weights, with the reference given the same.
void expect_every_variant_follows(const TwoLayerWeights& weights, Activation activation) {
  const ThinningOperation& operation = *find_thinning_operation(
      activation == Activation::linear ? "net_two_layer_linear" : "net_two_layer_sigmoid");
  const auto model = std::make_shared<const RuleModel>(two_layer_model(weights, activation));
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  const Outcome expected = reference_outcome(weights, activation, image.view());
  for (const ThinningVariant& variant : operation.variants) {
    if (!unavailable_reason(variant, 130).empty()) continue;
    if (variant.technique == Technique::simd_fixed_point && !model->fixed_point_is_exact) continue;
    const auto job = thinning_job({operation, variant, 130, 50, {2, model}});
    EXPECT_EQ(find_mismatch(*job, image.view(), expected).value_or(""), "")
        << technique_name(variant.technique) << " at " << isa_name(variant.isa);
  }
}

TEST(Models, eight_bits_refuse_a_bias_beyond_their_sums) {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.bias = 1e30F;
  EXPECT_FALSE(two_layer_model(weights, Activation::linear).fixed_point_is_exact);
}

TEST(Models, rounded_weights_are_right_on_251_and_252_descriptors) {
  const RuleModel& rule = paper_sigmoid_model();
  const auto right = [&](Activation activation) {
    const RuleModel rounded = two_layer_model(kRoundedTwoLayer, activation);
    int count = 0;
    for (int k = 256; k < 512; ++k) count += rounded.new_pixel[k] == rule.new_pixel[k] ? 1 : 0;
    return count;
  };
  EXPECT_EQ(right(Activation::sigmoid), 251);
  EXPECT_EQ(right(Activation::linear), 252);
}

TEST(Models, every_variant_follows_other_weights_not_the_known_rule) {
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  const Outcome rule = expected_of("thin_naccache_shinghal", image.view());
  for (const Activation activation : {Activation::linear, Activation::sigmoid}) {
    EXPECT_FALSE(equal(reference_outcome(damaged_net(), activation, image.view()).image.view(),
                       rule.image.view()));
    expect_every_variant_follows(damaged_net(), activation);
  }
}

TEST(Models, every_variant_follows_trained_weights) {
  for (const std::uint64_t seed : {2U, 3U}) {
    const TrainedTwoLayer trained = train_two_layer(stay_table_of_rule(), {.seed = seed});
    ASSERT_EQ(trained.right_linear, 256);
    expect_every_variant_follows(to_weights(trained.net), Activation::linear);
    expect_every_variant_follows(to_weights(trained.net), Activation::sigmoid);
  }
}

TEST(Models, malformed_weights_are_refused) {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.hidden[3].weight[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(two_layer_model(weights, Activation::linear)),
               std::invalid_argument);
  weights = kPaperTwoLayer;
  weights.output.bias = 2e30F;
  EXPECT_THROW(static_cast<void>(two_layer_model(weights, Activation::sigmoid)),
               std::invalid_argument);
  ClusterWeights cluster = kTrainedCluster;
  cluster.nets[11].last = 254;
  EXPECT_THROW(static_cast<void>(cluster_model(cluster)), std::invalid_argument);
  cluster.count = 17;
  EXPECT_THROW(static_cast<void>(cluster_model(cluster)), std::invalid_argument);
}

TEST(Plan, refuses_a_model_where_there_is_no_net) {
  const ThinningOperation& rule = *find_thinning_operation("thin_naccache_shinghal");
  const auto model = std::make_shared<const RuleModel>(paper_linear_model());
  EXPECT_THROW(ThinningPlan(rule, rule.variants.front(), 5, 5, {1, model}), std::invalid_argument);
}

TEST(Plan, refuses_eight_bits_for_a_model_they_cannot_express) {
  const ThinningOperation& net = *find_thinning_operation("net_two_layer_linear");
  auto model = std::make_shared<RuleModel>(paper_linear_model());
  model->fixed_point_is_exact = false;
  for (const ThinningVariant& variant : net.variants) {
    if (variant.technique != Technique::simd_fixed_point || !isa_available(variant.isa)) continue;
    EXPECT_THROW(ThinningPlan(net, variant, 5, 5, {1, model}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace thinbench
