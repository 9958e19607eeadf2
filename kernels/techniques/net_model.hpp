// Nets as plain data, safe to include in files of every ISA, and the kernels that evaluate them.
#pragma once

#include <array>
#include <cstdint>

#include "core/plane_view.hpp"
#include "engines/band.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench::detail {

/// Rounds to the nearest integer, ties away from zero.
constexpr float rounded_weight(float value) {
  return static_cast<float>(static_cast<int>(value < 0 ? value - 0.5F : value + 0.5F));
}

constexpr Neuron rounded_weights(Neuron neuron) {
  for (float& weight : neuron.weight) weight = rounded_weight(weight);
  neuron.bias = rounded_weight(neuron.bias);
  return neuron;
}

constexpr TwoLayerWeights rounded_weights(TwoLayerWeights net) {
  for (Neuron& neuron : net.hidden) neuron = rounded_weights(neuron);
  net.output = rounded_weights(net.output);
  return net;
}

/// Table 1 rounded to integers, as the paper does for integer arithmetic: correct on 251 of the 256
/// descriptors with the sigmoid and on 252 with the linear threshold.
inline constexpr TwoLayerWeights kRoundedTwoLayer = detail::rounded_weights(kPaperTwoLayer);

/// The two-layer net with a linear threshold in 8-bit fixed point. `weight` and `bias` are
/// multiples of 1 / scale; a hidden activation is an integer in [0, 2 limit] with limit = 3 scale.
/// A pixel is kept where output_bias + sum(output_weight * activation), in 16 bits, is at least 0.
struct FixedPointNet {
  std::int8_t weight[kHiddenNeurons][kNetInputs];
  std::int8_t bias[kHiddenNeurons];
  std::int8_t limit;
  std::int8_t output_weight[kHiddenNeurons];
  std::int16_t output_bias;
};

enum class NetKind : std::uint8_t { sigmoid, linear, cluster };

/// A net and what is derived from it.
struct NetModel {
  NetKind kind;
  TwoLayerWeights two_layer;
  ClusterWeights cluster;
  // The cluster, transposed: weight i of every net (i = 8: its bias), and its last descriptor (255
  // for unused nets).
  float cluster_column[kNetInputs + 1][kMaxClusterNets];
  float cluster_last[kMaxClusterNets];
  FixedPointNet fixed_point;
  bool fixed_point_is_exact;  // agrees with the float net on all 256 descriptors
};

/// `table` is what the net decides. Weights must be in range, see rules/nets.hpp.
[[nodiscard]] NetModel make_net_model(const TwoLayerWeights& weights, Activation activation,
                                      const WindowTable& table);
[[nodiscard]] NetModel make_net_model(const ClusterWeights& weights);

/// Applies a net to the active columns of a band and returns which of them changed. `previous` is
/// the image before the last iteration (background before the first). Otherwise as a Pass.
using NetPass = std::uint64_t (*)(const NetModel& net, const std::uint64_t* fixed,
                                  const ConstBitPlaneView& previous,
                                  const ConstBitPlaneView& source, const BitPlaneView& target,
                                  const Band& band);

/// Compiled per ISA.
struct NetPasses {
  std::array<NetPass, 3> float_bits;  // by NetKind
  NetPass fixed_point;                // two layers, linear threshold
};

}  // namespace thinbench::detail
