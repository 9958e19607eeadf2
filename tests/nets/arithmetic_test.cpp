// The arithmetic of the nets across lanes against the reference's, value by value.
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "nets/exponential.hpp"
#include "nets/make_model.hpp"
#include "nets/model_passes.hpp"
#include "nets/net_rows.hpp"
#include "reference.hpp"

namespace thinbench {
namespace {

/// Measured: where the output is near 0 its few units grow with the size of its net input.
constexpr int kMostOutputUnits = 9;

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
int most_units_apart(const RuleModel& model, void (*values_of)(const RuleModel&, float*), int first,
                     int last) {
  std::vector<float> values(256 * (kHiddenNeurons + 1));
  values_of(model, values.data());
  int most = 0;
  for (int j = first; j < last; ++j) {
    for (int k = 0; k < 256; ++k) {
      const float expected = reference_value(model.activation, j, k);
      most = std::max(most, units_apart(values[static_cast<std::size_t>(256 * j + k)], expected));
    }
  }
  return most;
}

template <Isa isa>
void judge() {
  if (!isa_available(isa)) {
    std::printf("%s is not available here\n", std::string(isa_name(isa)).c_str());
    return;
  }
  const NeuronValues& values = IsaModelPasses<isa>::kNeuronValues;
  const int all = kHiddenNeurons + 1;
  EXPECT_EQ(most_units_apart(paper_linear_model(), values.linear, 0, all), 0) << isa_name(isa);
  const RuleModel& sigmoid = paper_sigmoid_model();
  const int hidden = most_units_apart(sigmoid, values.sigmoid, 0, kHiddenNeurons);
  const int output = most_units_apart(sigmoid, values.sigmoid, kHiddenNeurons, all);
  EXPECT_LE(hidden, 2) << isa_name(isa);
  EXPECT_LE(output, kMostOutputUnits) << isa_name(isa);
  std::printf("%s: sigmoid, units in the last place from the reference: hidden %d, output %d\n",
              std::string(isa_name(isa)).c_str(), hidden, output);
}

TEST(NetArithmetic, linear_values_are_the_references_bits_and_sigmoid_values_are_close) {
  judge<Isa::baseline>();
  judge<Isa::sse42>();
  judge<Isa::avx2>();
  judge<Isa::avx512>();
  judge<Isa::avx512icl>();
}

TEST(Exponential, is_at_most_one_unit_in_the_last_place_from_the_true_value) {
  int most = 0;
  for (float x = -86.9F; x <= 86.9F; x += 0.000371F) {
    const auto expected = static_cast<float>(std::exp(static_cast<double>(x)));
    most = std::max(most, units_apart(exponential(x), expected));
  }
  EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace thinbench
