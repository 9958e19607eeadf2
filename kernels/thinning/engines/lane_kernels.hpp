// Kernels for many small images: one image a lane of a register.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/image_view.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

/// As wide as the widest lane.
inline constexpr Index kMaxLaneWidth = 128;

/// Rows of the widest register and the margin, in words: enough for every level.
constexpr Index lane_scratch_words(Index height) {
  return (height + 2 * kMarginRows) * kBlockWords;
}

/// The stacks are of one size and either the same or apart; their images have pixels and are up to
/// kMaxLaneWidth wide.
struct LaneJob {
  ConstStackView source;
  StackView target;
  int max_iterations;
  bool keep_border;
};

/// Thins images [first, last) and returns the largest number of cycles that one of them took, the
/// last included; 0 where there are none. `scratch` is `lane_scratch_words` words on a cache line
/// and may hold anything.
using LaneKernel = int (*)(const LaneJob& job, Index first, Index last, void* scratch);

struct LaneKernels {
  ByRule<LaneKernel> by_rule;
};

}  // namespace thinbench::detail
