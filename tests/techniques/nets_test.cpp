// Nets by every variant: any weights, and when 8-bit weights are exact.
#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "reference.hpp"
#include "rules/trained_cluster.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using detail::study::make_net;

detail::NetModel model_of(const Rule& net) {
  return dynamic_cast<const detail::study::NetBody&>(*detail::body_of(net)).model;
}

detail::NetModel linear_model(const TwoLayerWeights& weights) {
  return model_of(make_net(weights, Activation::linear));
}

TEST(NetModel, eight_bit_weights_are_exact_for_the_paper_s_linear_net) {
  EXPECT_TRUE(linear_model(kPaperTwoLayer).fixed_point_is_exact);
}

TwoLayerWeights inexact_in_eight_bits() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.bias = 1e30F;
  return weights;
}

TEST(NetModel, eight_bit_weights_are_inexact_for_a_huge_bias) {
  EXPECT_FALSE(linear_model(inexact_in_eight_bits()).fixed_point_is_exact);
}

Outcome reference_outcome(const TwoLayerWeights& weights, Activation activation, Border border,
                          const ConstImageView& image) {
  Outcome outcome{ByteImage(image.width, image.height), {}};
  outcome.numbers = {
      reference::net_two_layer(weights, activation, {border}, image, outcome.image.view())};
  return outcome;
}

/// Compares every available variant with the reference; without simd_fixed_point where no 8-bit
/// weights are exact.
void expect_every_variant_equals_reference(const TwoLayerWeights& weights, Activation activation) {
  const Rule rule = make_net(weights, activation);
  const bool is_exact = model_of(rule).fixed_point_is_exact;
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  for (const Border border : {Border::background, Border::keep}) {
    const Outcome expected = reference_outcome(weights, activation, border, image.view());
    const detail::ThinningParameters parameters = detail::thinning_parameters(rule, {border});
    for (const detail::ThinningVariant& variant : variants_of(parameters)) {
      if (!unavailable_reason(variant, 130).empty()) continue;
      if (variant.technique == "simd_fixed_point" && !is_exact) continue;
      const auto job = thinning_job(make_state(variant, 130, 50, parameters, 2));
      EXPECT_EQ(find_mismatch(*job, image.view(), expected).value_or(""), "")
          << name_of(variant) << ", border " << border_name(border);
    }
  }
}

TEST(Nets, every_variant_follows_weights_that_differ_from_the_rule) {
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
  ClusterWeights weights = detail::kTrainedCluster;
  weights.nets[5].neuron = {{}, 1.0F};
  return weights;
}

TEST(Nets, every_variant_follows_other_weights_of_a_cluster) {
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  ByteImage expected(130, 50);
  const int iterations = reference::net_single_layer_cluster(damaged_cluster(), {Border::keep},
                                                             image.view(), expected.view());
  ByteImage found(130, 50);
  for_each_state(detail::thinning_parameters(make_net(damaged_cluster()), {Border::keep}), 130, 50,
                 2, [&](detail::ThinningState& state, const std::string& name) {
                   EXPECT_EQ(state.run(image.view(), found.view()), iterations) << name;
                   EXPECT_TRUE(equal(found.view(), expected.view())) << name;
                 });
}

TEST(MakeState, rejects_fixed_point_for_a_net_without_exact_eight_bit_weights) {
  const Rule rule = make_net(inexact_in_eight_bits(), Activation::linear);
  ByteImage image(5, 5);
  EXPECT_EQ(rejection_of([&] { thin_by("simd_fixed_point", rule, image.view(), image.view()); }),
            "simd_fixed_point cannot run: no 8-bit weights reproduce the decisions of this net");
}

}  // namespace
}  // namespace thinbench
