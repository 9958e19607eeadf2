#include "nets/make_model.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "nets/exponential.hpp"

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

/// Rounds to multiples of 1 / scale; false where the result does not fit into 8 bits.
bool quantise(float value, float scale, std::int8_t& result) {
  const float scaled = std::nearbyint(value * scale);
  if (std::fabs(scaled) > 127) return false;
  result = static_cast<std::int8_t>(scaled);
  return true;
}

bool quantise(const Neuron& neuron, float scale, std::int8_t* weights, std::int8_t& bias) {
  float max_sum = std::fabs(neuron.bias);
  for (int i = 0; i < kNetInputs; ++i) {
    max_sum += std::fabs(neuron.weight[i]);
    if (!quantise(neuron.weight[i], scale, weights[i])) return false;
  }
  // Bounds partial sums in any order below 128: each of 9 terms is rounded by at most half a unit.
  return max_sum * scale + 4.5F < 127 && quantise(neuron.bias, scale, bias);
}

/// False where a weight or a sum would not fit its integer type.
bool make_fixed_point(const TwoLayerWeights& weights, float scale, FixedPointNet& net) {
  for (int j = 0; j < kHiddenNeurons; ++j) {
    if (!quantise(weights.hidden[j], scale, net.weight[j], net.bias[j])) return false;
  }
  net.limit = static_cast<std::int8_t>(3 * scale);
  const float max_hidden = 2.0F * static_cast<float>(net.limit);
  const float bias = std::nearbyint(weights.output.bias * scale * max_hidden);
  float max_sum = std::fabs(bias);
  for (int j = 0; j < kHiddenNeurons; ++j) {
    if (!quantise(weights.output.weight[j], scale, net.output_weight[j])) return false;
    max_sum += std::fabs(static_cast<float>(net.output_weight[j])) * max_hidden;
  }
  if (max_sum >= 32767) return false;
  net.output_bias = static_cast<std::int16_t>(bias);
  return true;
}

bool fixed_point_keeps(const FixedPointNet& net, int descriptor) {
  int sum = net.output_bias;
  for (int j = 0; j < kHiddenNeurons; ++j) {
    int x = net.bias[j];
    for (int i = 0; i < kNetInputs; ++i) x += (descriptor >> i & 1) * net.weight[j][i];
    const int limit = net.limit;
    sum += net.output_weight[j] * ((x < -limit ? -limit : (x > limit ? limit : x)) + limit);
  }
  return sum >= 0;
}

/// Finds the largest scale of 16, 8, 4, 2, 1 at which the fixed-point net agrees with the table.
void find_fixed_point(NetModel& model) {
  for (float scale = 16; scale >= 1 && !model.fixed_point_is_exact; scale /= 2) {
    if (!make_fixed_point(model.two_layer, scale, model.fixed_point)) continue;
    bool exact = true;
    for (int k = 0; k < 256; ++k) {
      exact = exact && fixed_point_keeps(model.fixed_point, k) == (model.new_pixel[256 + k] != 0);
    }
    model.fixed_point_is_exact = exact;
  }
}

void fill_columns(const ClusterWeights& weights, NetModel& model) {
  for (int net = 0; net < kMaxClusterNets; ++net) {
    const bool exists = net < weights.count;
    const Neuron neuron = exists ? weights.nets[net].neuron : Neuron{};
    for (int i = 0; i < kNetInputs; ++i) model.cluster_column[i][net] = neuron.weight[i];
    model.cluster_column[kNetInputs][net] = neuron.bias;
    model.cluster_last[net] = exists ? static_cast<float>(weights.nets[net].last) : 255.0F;
  }
}

/// Derives all tables that depend only on the decisions.
template <class Keeps>
void derive_tables(NetModel& model, const Keeps& keeps) {
  for (int k = 0; k < 256; ++k) model.new_pixel[256 + k] = keeps(k) ? 1 : 0;
  fill_pair_table(model.new_pixel, model.pixel_pairs);
}

}  // namespace

NetModel two_layer_model(const TwoLayerWeights& weights, Activation activation) {
  if (activation != Activation::sigmoid && activation != Activation::linear) {
    throw std::invalid_argument("activation: expected sigmoid or linear, got number " +
                                std::to_string(static_cast<int>(activation)));
  }
  for (int j = 0; j < kHiddenNeurons; ++j) {
    require_in_range(weights.hidden[j], "hidden neuron " + std::to_string(j));
  }
  require_in_range(weights.output, "the output neuron");
  NetModel model{};
  model.activation = activation;
  model.two_layer = weights;
  derive_tables(model, [&](int k) { return two_layer_keeps(weights, activation, k); });
  if (activation == Activation::linear) find_fixed_point(model);
  return model;
}

NetModel cluster_model(const ClusterWeights& weights) {
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
  NetModel model{};
  model.cluster = weights;
  fill_columns(weights, model);
  derive_tables(model, [&](int k) { return cluster_keeps(weights, k); });
  return model;
}

}  // namespace thinbench::detail

namespace thinbench {

std::shared_ptr<const NetModel> two_layer_net(const TwoLayerWeights& weights,
                                              Activation activation) {
  return std::make_shared<NetModel>(detail::two_layer_model(weights, activation));
}

std::shared_ptr<const NetModel> cluster_net(const ClusterWeights& weights) {
  return std::make_shared<NetModel>(detail::cluster_model(weights));
}

}  // namespace thinbench
