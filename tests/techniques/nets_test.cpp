// Nets: their tables, other weights by every variant, and when 8-bit weights are exact.
#include <gtest/gtest.h>

#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "reference.hpp"
#include "rules/built_in/naccache_shinghal.hpp"
#include "rules/rule_table.hpp"
#include "rules/trained_cluster.hpp"
#include "support/made_image.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"

namespace thinbench {
namespace {

using detail::kTrainedCluster;
using detail::study::make_net;

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

/// engines/rules_test.cpp has the sigmoid and clusters.
TEST(Nets, every_variant_follows_linear_weights_that_differ_from_the_rule) {
  const ByteImage image = noise_image(130, 50, 90, 1, 4);
  const Rule rule = make_net(damaged_net(), Activation::linear);
  for (const Border border : {Border::background, Border::keep}) {
    Outcome expected{ByteImage(130, 50), {}};
    expected.numbers = {reference::net_two_layer(damaged_net(), Activation::linear, {border},
                                                 image.view(), expected.image.view())};
    EXPECT_FALSE(equal(expected.image.view(), thinned(Rule::naccache_shinghal, image).view()));
    const detail::ThinningParameters parameters = detail::thinning_parameters(rule, {border});
    for (const detail::ThinningVariant& variant : variants_of(parameters)) {
      if (!unavailable_reason(variant, 130).empty()) continue;
      if (variant.technique == "simd_fixed_point" && !model_of(rule).fixed_point_is_exact) continue;
      const auto job = thinning_job(make_state(variant, 130, 50, parameters, 2));
      EXPECT_EQ(find_mismatch(*job, image.view(), expected).value_or(""), "")
          << name_of(variant) << ", border " << border_name(border);
    }
  }
}

TEST(MakeState, rejects_fixed_point_for_a_net_without_exact_eight_bit_weights) {
  const Rule rule = make_net(inexact_in_eight_bits(), Activation::linear);
  ByteImage image(5, 5);
  EXPECT_EQ(rejection_of([&] { thin_by("simd_fixed_point", rule, image.view(), image.view()); }),
            "simd_fixed_point cannot run: no 8-bit weights reproduce the decisions of this net");
}

}  // namespace
}  // namespace thinbench
