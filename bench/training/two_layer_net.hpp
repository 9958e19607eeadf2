// The two-layer net of section 3.2 with any number of hidden neurons, for training and experiments.
// The equations are written once, over any number type: float, or one that counts operations.
#pragma once

#include <vector>

#include "training/portable_math.hpp"
#include "training/stay_table.hpp"

namespace thinbench {

struct HiddenLayerNet {
  std::vector<Neuron> hidden;
  std::vector<float> output_weight;  // as many as hidden neurons
  float output_bias = 0;
};

[[nodiscard]] HiddenLayerNet to_net(const TwoLayerWeights& weights);

/// Throws std::invalid_argument unless the net has eight hidden neurons.
[[nodiscard]] TwoLayerWeights to_weights(const HiddenLayerNet& net);

inline float exponential_of(float x) {
  return static_cast<float>(portable_exp(static_cast<double>(x)));
}

/// Equation (1) or (2).
template <class Number>
Number activate(Number x, Activation activation) {
  if (activation == Activation::kSigmoid) return Number(1.0F) / (Number(1.0F) + exponential_of(-x));
  if (x > Number(3.0F)) return Number(1.0F);
  if (x < Number(-3.0F)) return Number(0.0F);
  return Number(0.166F) * x + Number(0.5F);
}

/// Equation (3) and the step function (4): whether a dark pixel with these neighbours, 0 or 1,
/// stays.
template <class Number>
bool net_keeps(const HiddenLayerNet& net, const Number (&n)[kNetInputs], Activation activation) {
  Number out(net.output_bias);
  for (std::size_t j = 0; j < net.hidden.size(); ++j) {
    Number sum(net.hidden[j].bias);
    for (int i = 0; i < kNetInputs; ++i) sum = sum + Number(net.hidden[j].weight[i]) * n[i];
    out = out + Number(net.output_weight[j]) * activate(sum, activation);
  }
  return activate(out, activation) >= Number(0.5F);
}

/// What the net says of each descriptor.
[[nodiscard]] StayTable table_of(const HiddenLayerNet& net, Activation activation);

/// Entries that two tables share, of 256.
[[nodiscard]] int agreement(const StayTable& a, const StayTable& b);

}  // namespace thinbench
