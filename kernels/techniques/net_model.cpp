#include "techniques/net_model.hpp"

#include <cmath>

#include "rules/rule_table.hpp"

namespace thinbench::detail {
namespace {

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

bool agrees(const FixedPointNet& net, const WindowTable& table) {
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    const int descriptor = static_cast<int>(descriptor_of(window)) - 256;
    if (descriptor >= 0 && fixed_point_keeps(net, descriptor) != table[window]) return false;
  }
  return true;
}

/// Finds the largest scale of 16, 8, 4, 2, 1 at which the fixed-point net agrees with the table.
void find_fixed_point(NetModel& model, const WindowTable& table) {
  for (float scale = 16; scale >= 1 && !model.fixed_point_is_exact; scale /= 2) {
    model.fixed_point_is_exact = make_fixed_point(model.two_layer, scale, model.fixed_point) &&
                                 agrees(model.fixed_point, table);
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

}  // namespace

NetModel make_net_model(const TwoLayerWeights& weights, Activation activation,
                        const WindowTable& table) {
  NetModel model{};
  model.kind = activation == Activation::linear ? NetKind::linear : NetKind::sigmoid;
  model.two_layer = weights;
  if (model.kind == NetKind::linear) find_fixed_point(model, table);
  return model;
}

NetModel make_net_model(const ClusterWeights& weights) {
  NetModel model{};
  model.kind = NetKind::cluster;
  model.cluster = weights;
  fill_columns(weights, model);
  return model;
}

}  // namespace thinbench::detail
