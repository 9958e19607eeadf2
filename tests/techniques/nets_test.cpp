// Nets: their tables, other weights by every variant, when 8-bit weights are exact, and vectorised
// arithmetic against the reference, value by value.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "core/exported.hpp"
#include "harness/families.hpp"
#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "reference.hpp"
#include "rules/built_in/naccache_shinghal.hpp"
#include "rules/exponential.hpp"
#include "rules/rule_table.hpp"
#include "rules/trained_cluster.hpp"
#include "support/isa_tests.hpp"
#include "support/made_image.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "techniques/neuron_values.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {
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

// Measured maxima in units in the last place (ULP). Near 0, the error of the output grows with the
// magnitude of its net input.
constexpr int kMaxHiddenUlps = 2;
constexpr int kMaxOutputUlps = 9;

/// Distance of two positive numbers in ULPs.
int ulp_distance(float a, float b) {
  std::int32_t bits_a = 0;
  std::int32_t bits_b = 0;
  std::memcpy(&bits_a, &a, sizeof a);
  std::memcpy(&bits_b, &b, sizeof b);
  return std::abs(bits_a - bits_b);
}

/// Neurons 0 to 7 are hidden, 8 is the output.
float reference_value(Activation activation, int neuron, int descriptor) {
  float inputs[kNetInputs];
  for (int i = 0; i < kNetInputs; ++i) inputs[i] = static_cast<float>(descriptor >> i & 1);
  if (neuron == kHiddenNeurons) {
    return reference::two_layer_output(kPaperTwoLayer, activation, inputs);
  }
  const Neuron& weights = kPaperTwoLayer.hidden[neuron];
  float sum = weights.bias;
  for (int i = 0; i < kNetInputs; ++i) sum += weights.weight[i] * inputs[i];
  return reference::activation_output(activation, sum);
}

/// The maximum distance from the reference over neurons [first, last) and all descriptors.
int max_ulp_distance(const NetModel& model, void (*values_of)(const NetModel&, float*), int first,
                     int last) {
  const Activation activation =
      model.kind == NetKind::linear ? Activation::linear : Activation::sigmoid;
  std::vector<float> values(256 * (kHiddenNeurons + 1));
  values_of(model, values.data());
  int max_ulps = 0;
  for (int j = first; j < last; ++j) {
    for (int k = 0; k < 256; ++k) {
      const float expected = reference_value(activation, j, k);
      const float found = values[static_cast<std::size_t>(256 * j + k)];
      max_ulps = std::max(max_ulps, ulp_distance(found, expected));
    }
  }
  return max_ulps;
}

NetModel paper_model(Activation activation) {
  const Rule rule = Rule::from_net(kPaperTwoLayer, activation);
  return make_net_model(kPaperTwoLayer, activation, rule.sub_iterations().front());
}

class NetArithmetic : public IsaTest {
 protected:
  [[nodiscard]] static const NeuronValues& kernels() {
    return kernels_of<NeuronValues>(GetParam());
  }
};

TEST_P(NetArithmetic, equals_the_reference_bit_for_bit_with_the_linear_threshold) {
  const NetModel model = paper_model(Activation::linear);
  EXPECT_EQ(max_ulp_distance(model, kernels().linear, 0, kHiddenNeurons + 1), 0);
}

TEST_P(NetArithmetic, is_close_to_the_reference_with_the_sigmoid) {
  const NetModel model = paper_model(Activation::sigmoid);
  const auto sigmoid = kernels().sigmoid;
  const int hidden = max_ulp_distance(model, sigmoid, 0, kHiddenNeurons);
  const int output = max_ulp_distance(model, sigmoid, kHiddenNeurons, kHiddenNeurons + 1);
  EXPECT_LE(hidden, kMaxHiddenUlps);
  EXPECT_LE(output, kMaxOutputUlps);
  RecordProperty("hidden_ulps", hidden);
  RecordProperty("output_ulps", output);
}

INSTANTIATE_TEST_SUITE_P(Isas, NetArithmetic, testing::ValuesIn(detail::kIsas), isa_test_name);

TEST(Exponential, differs_from_the_true_value_by_at_most_one_ulp) {
  int max_ulps = 0;
  for (float x = -86.9F; x <= 86.9F; x += 0.000371F) {
    const auto expected = static_cast<float>(std::exp(static_cast<double>(x)));
    max_ulps = std::max(max_ulps, ulp_distance(exponential(x), expected));
  }
  EXPECT_EQ(max_ulps, 1);
}

}  // namespace
}  // namespace thinbench::detail
