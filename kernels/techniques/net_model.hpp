// Nets as plain data, safe to include in files of every ISA.
#pragma once

#include <cstdint>

#include "techniques/table_rule.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/window_table.hpp"

namespace thinbench::detail {

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

/// A net and the tables derived from it.
struct NetModel : TableRule {
  Activation activation;
  TwoLayerWeights two_layer;
  ClusterWeights cluster;
  // The cluster, transposed: weight i of every net (i = 8: its bias), and its last descriptor (255
  // for unused nets).
  float cluster_column[kNetInputs + 1][kMaxClusterNets];
  float cluster_last[kMaxClusterNets];
  FixedPointNet fixed_point;
  bool fixed_point_is_exact;  // agrees with the float net on all 256 descriptors
};

/// The table of a pass, which must be that of a net.
inline const NetModel& net_of(const TableRule* rule) {
  return *static_cast<const NetModel*>(rule);
}

/// `table` is what the net decides. Weights must be in range, see rules/nets.hpp.
[[nodiscard]] NetModel make_net_model(const TwoLayerWeights& weights, Activation activation,
                                      const WindowTable& table);
[[nodiscard]] NetModel make_net_model(const ClusterWeights& weights, const WindowTable& table);

}  // namespace thinbench::detail
