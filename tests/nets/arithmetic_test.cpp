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

/// Distance in units in the last place; both are positive.
int units_apart(float a, float b) {
  std::int32_t bits_a = 0;
  std::int32_t bits_b = 0;
  std::memcpy(&bits_a, &a, sizeof a);
  std::memcpy(&bits_b, &b, sizeof b);
  return std::abs(bits_a - bits_b);
}

float reference_hidden(Activation activation, int neuron, int descriptor) {
  const Neuron& weights = kPaperTwoLayer.hidden[neuron];
  float sum = weights.bias;
  for (int i = 0; i < kNetInputs; ++i) {
    sum += weights.weight[i] * static_cast<float>(descriptor >> i & 1);
  }
  return reference::activation_answer(activation, sum);
}

/// The largest distance from the reference over all neurons and descriptors.
int most_units_apart(const RuleModel& model, void (*values_of)(const RuleModel&, float*)) {
  std::vector<float> values(256 * kHiddenNeurons);
  values_of(model, values.data());
  int most = 0;
  for (int j = 0; j < kHiddenNeurons; ++j) {
    for (int k = 0; k < 256; ++k) {
      const float expected = reference_hidden(model.activation, j, k);
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
  const HiddenValues& values = IsaModelPasses<isa>::kHiddenValues;
  EXPECT_EQ(most_units_apart(paper_linear_model(), values.linear), 0) << isa_name(isa);
  const int sigmoid = most_units_apart(paper_sigmoid_model(), values.sigmoid);
  EXPECT_LE(sigmoid, 2) << isa_name(isa);
  std::printf("%s: sigmoid at most %d units in the last place from the reference\n",
              std::string(isa_name(isa)).c_str(), sigmoid);
}

TEST(NetArithmetic, linear_values_are_the_references_bits_and_sigmoid_values_are_within_two_units) {
  judge<Isa::kBaseline>();
  judge<Isa::kSse42>();
  judge<Isa::kAvx2>();
  judge<Isa::kAvx512>();
  judge<Isa::kAvx512Icl>();
}

TEST(Exponential, is_within_four_units_of_the_true_value) {
  for (float x = -80.0F; x <= 80.0F; x += 0.00371F) {
    const auto expected = static_cast<float>(std::exp(static_cast<double>(x)));
    EXPECT_LE(units_apart(exponential(x), expected), 4) << x;
  }
}

}  // namespace
}  // namespace thinbench
