// Whole-image kernels that hold each row of up to 512 pixels in one 512-bit register.
#pragma once

#include "dispatch/isa.hpp"
#include "image/plane_view.hpp"
#include "thinning/engines/passes.hpp"
#include "thinning/rules.hpp"

namespace thinbench::detail {

inline constexpr Index kRowKernelWidth = 512;

/// Rows are grouped in at most 64 bands, one bit of a word each, of at least 8 rows.
constexpr Index row_kernel_band_rows(Index height) {
  constexpr Index least = 8;
  return height <= 64 * least ? least : (height + 63) / 64;
}

constexpr Index row_kernel_bands(Index height) {
  const Index rows = row_kernel_band_rows(height);
  return (height + rows - 1) / rows;
}

/// Whole bands and the margin, in words.
constexpr Index row_kernel_scratch_words(Index height) {
  return (row_kernel_bands(height) * row_kernel_band_rows(height) + 2 * kMarginRows) * kBlockWords;
}

/// Repeats a rule until nothing changes or `max_iterations` are done; returns the number of cycles,
/// the last included. Reads `source` and writes `target` once; works in `scratch`,
/// `row_kernel_scratch_words` words on a cache line, of which all beyond the image's own rows must
/// be zero and stay so. Needs width <= 512. `model` is nullptr for rules that need none.
using RowKernel = int (*)(const RuleModel* model, int max_iterations, const ConstBitPlaneView& source,
                          const BitPlaneView& target, std::uint64_t* scratch);

template <class... Rules>
consteval int rule_count(RuleList<Rules...>) {
  return sizeof...(Rules);
}

/// The position of `Rule` in every table of one entry a rule.
template <class Rule, class... Rules>
consteval int rule_index(RuleList<Rules...>) {
  int index = 0;
  bool found = false;
  ((found = found || __is_same(Rule, Rules), index += found ? 0 : 1), ...);
  return index;
}

struct RowKernelTable {
  RowKernel kernels[rule_count(AllRules{})];
};

/// Compiled for the AVX-512 levels only.
template <Isa isa>
struct RowKernels {
  static const RowKernelTable kTable;
  static const RowKernel kModel;  // any rule of eight neighbours, from a model
};

}  // namespace thinbench::detail
