#include "rules/nets.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "rules/exponential.hpp"
#include "rules/rule_table.hpp"

namespace thinbench::detail {
namespace {

float net_input(const Neuron& neuron, const float* inputs) {
  float sum = neuron.bias;
  for (int i = 0; i < kNetInputs; ++i) sum = sum + neuron.weight[i] * inputs[i];
  return sum;
}

float activated(Activation activation, float x) {
  if (activation == Activation::sigmoid) return sigmoid(x);
  if (x > 3.0F) return 1.0F;
  if (x < -3.0F) return 0.0F;
  return 0.166F * x + 0.5F;
}

void inputs_of(int descriptor, float* inputs) {
  for (int i = 0; i < kNetInputs; ++i) inputs[i] = static_cast<float>(descriptor >> i & 1);
}

void require_in_range(float value, const std::string& name) {
  constexpr float max_weight = 1e30F;          // keeps every sum finite
  if (std::fabs(value) <= max_weight) return;  // false for NaN
  throw std::invalid_argument(name + ": expected a number in [-1e30, 1e30], got " +
                              std::to_string(value));
}

void require_in_range(const Neuron& neuron, const std::string& name) {
  for (int i = 0; i < kNetInputs; ++i) {
    require_in_range(neuron.weight[i], "weight " + std::to_string(i) + " of " + name);
  }
  require_in_range(neuron.bias, "the bias of " + name);
}

bool two_layer_keeps(const TwoLayerWeights& weights, Activation activation, int descriptor) {
  float inputs[kNetInputs];
  inputs_of(descriptor, inputs);
  float hidden[kHiddenNeurons];
  for (int j = 0; j < kHiddenNeurons; ++j) {
    hidden[j] = activated(activation, net_input(weights.hidden[j], inputs));
  }
  return activated(activation, net_input(weights.output, hidden)) >= 0.5F;
}

bool cluster_keeps(const ClusterWeights& weights, int descriptor) {
  int net = 0;
  while (descriptor > weights.nets[net].last) ++net;
  float inputs[kNetInputs];
  inputs_of(descriptor, inputs);
  return net_input(weights.nets[net].neuron, inputs) >= 0.0F;
}

/// The table of a rule that keeps the foreground pixels whose descriptor `keeps` accepts.
template <class Keeps>
WindowTable table_that(const Keeps& keeps) {
  return make_window_table([&](std::size_t window) {
    const std::size_t descriptor = descriptor_of(window);
    return descriptor >= 256 && keeps(static_cast<int>(descriptor - 256));
  });
}

}  // namespace

WindowTable table_of(const TwoLayerWeights& weights, Activation activation) {
  if (activation != Activation::sigmoid && activation != Activation::linear) {
    throw std::invalid_argument("activation: expected sigmoid or linear, got number " +
                                std::to_string(static_cast<int>(activation)));
  }
  for (int j = 0; j < kHiddenNeurons; ++j) {
    require_in_range(weights.hidden[j], "hidden neuron " + std::to_string(j));
  }
  require_in_range(weights.output, "the output neuron");
  return table_that([&](int k) { return two_layer_keeps(weights, activation, k); });
}

WindowTable table_of(const ClusterWeights& weights) {
  if (weights.count < 1 || weights.count > kMaxClusterNets) {
    throw std::invalid_argument("the cluster has " + std::to_string(weights.count) +
                                " nets; it must have 1 to " + std::to_string(kMaxClusterNets));
  }
  int before = -1;
  for (int net = 0; net < weights.count; ++net) {
    require_in_range(weights.nets[net].neuron, "net " + std::to_string(net));
    if (weights.nets[net].last <= before) {
      throw std::invalid_argument("net " + std::to_string(net) + " covers no descriptor");
    }
    before = weights.nets[net].last;
  }
  if (before != 255) {
    throw std::invalid_argument("the nets end at descriptor " + std::to_string(before) +
                                ", not 255");
  }
  return table_that([&](int k) { return cluster_keeps(weights, k); });
}

}  // namespace thinbench::detail
