#include "rules/nets.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace thinbench::detail {
namespace {

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
  return decisions_of(weights, activation);
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
  return decisions_of(weights);
}

}  // namespace thinbench::detail
