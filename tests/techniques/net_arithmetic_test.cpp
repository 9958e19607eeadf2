// The vectorised arithmetic of the nets against the reference, value by value.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "core/exported.hpp"
#include "reference.hpp"
#include "rules/exponential.hpp"
#include "support/isa_parameters.hpp"
#include "techniques/neuron_values.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {
namespace {

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
