// A rule that is known at run time only: a net, and all that engines derive from it. Plain data, so
// that files of every instruction-set level can read it.
#pragma once

#include <cstdint>

#include "nets/weights.hpp"

namespace thinbench::detail {

/// The two-layer net with a linear threshold in 8-bit fixed point: `weight` and `bias` hold
/// multiples of 1 / scale, a hidden answer is an integer in [0, 2 limit] with limit = 3 scale, and
/// the net says dark where the sum of output weights times answers plus the output's bias, in 16
/// bits, is not negative.
struct FixedPointNet {
  std::int8_t weight[kHiddenNeurons][kNetInputs];
  std::int8_t bias[kHiddenNeurons];
  std::int8_t limit;
  std::int8_t output_weight[kHiddenNeurons];
  std::int16_t output_bias;
};

/// One step of a decision diagram: the value numbered `high` where the neighbour n_variable is
/// dark, else the one numbered `low`. Values 0 and 1 are light and dark, value i + 2 is that of
/// node i.
struct MuxNode {
  std::uint8_t variable;
  std::uint8_t high;
  std::uint8_t low;
};

/// A truth table over the eight neighbours as a reduced ordered decision diagram; the last value is
/// the result. With eight variables no order needs more than 79 nodes.
struct MuxProgram {
  static constexpr int kMaxNodes = 79;
  int count;
  MuxNode nodes[kMaxNodes];
};

struct RuleModel {
  Activation activation;
  TwoLayerWeights two_layer;
  ClusterWeights cluster;
  // The cluster by columns: weight i (or the bias, i = 8) of every net, and its last descriptor;
  // beyond the last net, descriptors that never come.
  float cluster_column[kNetInputs + 1][kMaxClusterNets];
  float cluster_last[kMaxClusterNets];
  FixedPointNet fixed_point;
  bool fixed_point_is_exact;        // equal to the float net on all 256 descriptors
  std::uint8_t new_pixel[512];      // by k + 256 p; 0 or 1
  std::uint16_t pixel_pairs[4096];  // the same for windows of four columns, see lut.cpp
  MuxProgram program;               // new_pixel[256 ... 511]
};

}  // namespace thinbench::detail
