// Kernels for many small images: one image a lane of a register.
#pragma once

#include <array>

#include "dispatch/isa.hpp"
#include "image/stack.hpp"
#include "thinning/engines/row_kernel.hpp"

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

struct LaneKernelTable {
  LaneKernel kernels[rule_count(AllRules{})];
};

/// Compiled once for every instruction-set level.
template <Isa isa>
struct LaneKernels {
  static const LaneKernelTable kTable;
};

/// The kernels of one rule by level, in the order of Isa.
using LaneKernelRows = std::array<const LaneKernel*, kAllIsas.size()>;

template <class Rule>
const LaneKernelRows& lane_kernels_of() {
  constexpr int rule = rule_index<Rule>(AllRules{});
  static constexpr LaneKernelRows rows = {&LaneKernels<Isa::baseline>::kTable.kernels[rule],
                                          &LaneKernels<Isa::sse42>::kTable.kernels[rule],
                                          &LaneKernels<Isa::avx2>::kTable.kernels[rule],
                                          &LaneKernels<Isa::avx512>::kTable.kernels[rule],
                                          &LaneKernels<Isa::avx512icl>::kTable.kernels[rule]};
  return rows;
}

}  // namespace thinbench::detail
