// A net as engines see it. Plain data, so that files of every ISA can read it.
#pragma once

#include <cstdint>

#include "thinbench/nets.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

/// The two-layer net with a linear threshold in 8-bit fixed point: `weight` and `bias` hold
/// multiples of 1 / scale, a hidden answer is an integer in [0, 2 limit] with limit = 3 scale, and
/// the net says foreground where the sum of output weights times answers plus the output's bias, in
/// 16 bits, is not negative.
struct FixedPointNet {
  std::int8_t weight[kHiddenNeurons][kNetInputs];
  std::int8_t bias[kHiddenNeurons];
  std::int8_t limit;
  std::int8_t output_weight[kHiddenNeurons];
  std::int16_t output_bias;
};

}  // namespace thinbench::detail

namespace thinbench {

/// A net, and all that engines derive from it.
struct NetModel : detail::RuntimeRule {
  Activation activation;
  TwoLayerWeights two_layer;
  ClusterWeights cluster;
  // The cluster by columns: weight i (or the bias, i = 8) of every net, and its last descriptor;
  // beyond the last net, descriptors that never come.
  float cluster_column[kNetInputs + 1][kMaxClusterNets];
  float cluster_last[kMaxClusterNets];
  detail::FixedPointNet fixed_point;
  bool fixed_point_is_exact;  // equal to the float net on all 256 descriptors
};

}  // namespace thinbench

namespace thinbench::detail {

/// The net that a pass is given as its rule.
inline const NetModel& net_of(const RuntimeRule* rule) {
  return *static_cast<const NetModel*>(rule);
}

}  // namespace thinbench::detail
