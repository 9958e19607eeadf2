// Nets as engines read them: plain data, for files of every ISA.
#pragma once

#include <cstdint>

#include "thinbench/nets.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

/// The two-layer net with linear threshold in 8-bit fixed point. `weight` and `bias` hold multiples
/// of 1 / scale; a hidden activation is an integer in [0, 2 limit] with limit = 3 scale. The new
/// pixel is foreground where the sum of output weights times activations plus output bias, in 16
/// bits, is not negative.
struct FixedPointNet {
  std::int8_t weight[kHiddenNeurons][kNetInputs];
  std::int8_t bias[kHiddenNeurons];
  std::int8_t limit;
  std::int8_t output_weight[kHiddenNeurons];
  std::int16_t output_bias;
};

}  // namespace thinbench::detail

namespace thinbench {

/// A net and all that is derived from it.
struct NetModel : detail::RuntimeRule {
  Activation activation;
  TwoLayerWeights two_layer;
  ClusterWeights cluster;
  // The cluster, transposed: weight i (i = 8: the bias) of every net, and its last descriptor; 255
  // beyond the last net.
  float cluster_column[kNetInputs + 1][kMaxClusterNets];
  float cluster_last[kMaxClusterNets];
  detail::FixedPointNet fixed_point;
  bool fixed_point_is_exact;  // equal to the float net on all 256 descriptors
};

}  // namespace thinbench

namespace thinbench::detail {

/// The net that an engine gets as its rule.
inline const NetModel& net_of(const RuntimeRule* rule) {
  return *static_cast<const NetModel*>(rule);
}

}  // namespace thinbench::detail
