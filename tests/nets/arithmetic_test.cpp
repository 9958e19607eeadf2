// The arithmetic of the nets across lanes against the reference's, value by value.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "dispatch/exported.hpp"
#include "nets/exponential.hpp"
#include "nets/neuron_values.hpp"
#include "nets/variants.hpp"
#include "reference.hpp"

namespace thinbench::detail {
namespace {

// Measured, in units in the last place: where the output is near 0 its few units grow with the size
// of its net input.
constexpr int kMaxHiddenUnits = 2;
constexpr int kMaxOutputUnits = 9;

/// Distance in units in the last place; both are positive.
int units_apart(float a, float b) {
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
    return reference::two_layer_answer(kPaperTwoLayer, activation, inputs);
  }
  const Neuron& weights = kPaperTwoLayer.hidden[neuron];
  float sum = weights.bias;
  for (int i = 0; i < kNetInputs; ++i) sum += weights.weight[i] * inputs[i];
  return reference::activation_answer(activation, sum);
}

/// The largest distance from the reference over neurons [first, last) and all descriptors.
int max_units_apart(const NetModel& model, void (*values_of)(const NetModel&, float*), int first,
                    int last) {
  std::vector<float> values(256 * (kHiddenNeurons + 1));
  values_of(model, values.data());
  int max_units = 0;
  for (int j = first; j < last; ++j) {
    for (int k = 0; k < 256; ++k) {
      const float expected = reference_value(model.activation, j, k);
      const float found = values[static_cast<std::size_t>(256 * j + k)];
      max_units = std::max(max_units, units_apart(found, expected));
    }
  }
  return max_units;
}

class NetArithmetic : public testing::TestWithParam<Isa> {
 protected:
  void SetUp() override {
    if (!isa_available(GetParam())) GTEST_SKIP() << isa_name(GetParam()) << " is not available";
  }
  [[nodiscard]] static const NeuronValues& kernels() {
    return kernels_of<NeuronValues>(GetParam());
  }
};

TEST_P(NetArithmetic, gives_the_bits_of_the_reference_with_the_linear_threshold) {
  const NetModel& model = *default_net(Rule::net_two_layer_linear);
  EXPECT_EQ(max_units_apart(model, kernels().linear, 0, kHiddenNeurons + 1), 0);
}

TEST_P(NetArithmetic, is_close_to_the_reference_with_the_sigmoid) {
  const NetModel& model = *default_net(Rule::net_two_layer_sigmoid);
  const auto sigmoid = kernels().sigmoid;
  const int hidden = max_units_apart(model, sigmoid, 0, kHiddenNeurons);
  const int output = max_units_apart(model, sigmoid, kHiddenNeurons, kHiddenNeurons + 1);
  EXPECT_LE(hidden, kMaxHiddenUnits);
  EXPECT_LE(output, kMaxOutputUnits);
  RecordProperty("hidden_units_in_the_last_place", hidden);
  RecordProperty("output_units_in_the_last_place", output);
}

INSTANTIATE_TEST_SUITE_P(Isas, NetArithmetic, testing::ValuesIn(kAllIsas), [](const auto& tested) {
  return "isa" + std::to_string(static_cast<int>(tested.param));
});

TEST(Exponential, is_at_most_one_unit_in_the_last_place_from_the_true_value) {
  int max_units = 0;
  for (float x = -86.9F; x <= 86.9F; x += 0.000371F) {
    const auto expected = static_cast<float>(std::exp(static_cast<double>(x)));
    max_units = std::max(max_units, units_apart(exponential(x), expected));
  }
  EXPECT_EQ(max_units, 1);
}

}  // namespace
}  // namespace thinbench::detail
