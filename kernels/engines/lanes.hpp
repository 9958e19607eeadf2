// Kernels for many small images: one image per lane of a register.
#pragma once

#include "core/exported.hpp"
#include "core/plane_view.hpp"
#include "scan/bound_rule.hpp"
#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// In pixels: a pair of 64-bit lanes.
inline constexpr Index kMaxLaneWidth = 128;

/// Image and margin rows, in words. Sufficient for the widest registers, hence for every ISA.
constexpr Index lane_scratch_words(Index height) {
  return (height + 2 * kMarginRows) * kBlockWords;
}

/// The stacks have equal sizes and are identical or disjoint. Images are not empty and at most
/// kMaxLaneWidth pixels wide.
struct LaneJob {
  ConstStackView source;
  StackView target;
  int max_iterations;
  bool keep_border;
  bool complemented;      // see ThinningParameters
  const BoundRule* rule;  // bound to lane_layout(), with fixed pixels if it needs them
};

/// The layout of images of this width, which is at most kMaxLaneWidth.
constexpr Layout lane_layout(Index width) {
  if (width <= 32) return Layout::lanes_32;
  return width <= 64 ? Layout::lanes_64 : Layout::lanes_128;
}

/// Thins images [first, last). Returns the maximum number of iterations of an image, including the
/// last; 0 for an empty range. `scratch` has lane_scratch_words() words, aligned to a cache line,
/// and may be uninitialised.
using LaneKernel = int (*)(const LaneJob& job, Index first, Index last, void* scratch);

struct LaneKernels {
  LaneKernel thin;
};
template <>
inline constexpr Features kGainsFrom<LaneKernels> = feature("avx2") | feature("avx512bw");

}  // namespace thinbench::detail
