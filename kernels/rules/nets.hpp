// What nets decide, as tables.
#pragma once

#include "rules/exponential.hpp"
#include "rules/rule_table.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench::detail {

constexpr float net_input(const Neuron& neuron, const float* inputs) {
  float sum = neuron.bias;
  for (int i = 0; i < kNetInputs; ++i) sum = sum + neuron.weight[i] * inputs[i];
  return sum;
}

constexpr float activated(Activation activation, float x) {
  if (activation == Activation::sigmoid) return sigmoid(x);
  if (x > 3.0F) return 1.0F;
  if (x < -3.0F) return 0.0F;
  return 0.166F * x + 0.5F;
}

constexpr void inputs_of(int descriptor, float* inputs) {
  for (int i = 0; i < kNetInputs; ++i) inputs[i] = static_cast<float>(descriptor >> i & 1);
}

constexpr bool two_layer_keeps(const TwoLayerWeights& weights, Activation activation,
                               int descriptor) {
  float inputs[kNetInputs] = {};
  inputs_of(descriptor, inputs);
  float hidden[kHiddenNeurons] = {};
  for (int j = 0; j < kHiddenNeurons; ++j) {
    hidden[j] = activated(activation, net_input(weights.hidden[j], inputs));
  }
  return activated(activation, net_input(weights.output, hidden)) >= 0.5F;
}

constexpr bool cluster_keeps(const ClusterWeights& weights, int descriptor) {
  int net = 0;
  while (descriptor > weights.nets[net].last) ++net;
  float inputs[kNetInputs] = {};
  inputs_of(descriptor, inputs);
  return net_input(weights.nets[net].neuron, inputs) >= 0.0F;
}

/// The table of a rule that keeps the foreground pixels whose descriptor `keeps` accepts.
template <class Keeps>
constexpr WindowTable table_that(const Keeps& keeps) {
  return make_window_table([&](std::size_t window) {
    const std::size_t descriptor = descriptor_of(window);
    return descriptor >= 256 && keeps(static_cast<int>(descriptor - 256));
  });
}

/// Of nets whose weights are in range.
constexpr WindowTable decisions_of(const TwoLayerWeights& weights, Activation activation) {
  return table_that([&](int k) { return two_layer_keeps(weights, activation, k); });
}
constexpr WindowTable decisions_of(const ClusterWeights& weights) {
  return table_that([&](int k) { return cluster_keeps(weights, k); });
}

/// The two-layer net of section 3.2. Throws std::invalid_argument for a weight outside
/// [-1e30, 1e30].
[[nodiscard]] WindowTable table_of(const TwoLayerWeights& weights, Activation activation);

/// The cluster of section 3.3. Throws std::invalid_argument for a weight outside [-1e30, 1e30] and
/// for nets that do not cover the descriptors 0 to 255 in order.
[[nodiscard]] WindowTable table_of(const ClusterWeights& weights);

}  // namespace thinbench::detail
