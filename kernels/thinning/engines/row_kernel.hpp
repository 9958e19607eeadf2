// Whole-image kernels that hold each row of up to 512 pixels in one register.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/options.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

inline constexpr Index kRowKernelWidth = 512;

/// Rows are grouped in at most 64 bands, one bit of a word each, of at least 8 rows.
constexpr Index row_kernel_band_rows(Index height) {
  constexpr Index min_rows = 8;
  return height <= 64 * min_rows ? min_rows : (height + 63) / 64;
}

constexpr Index row_kernel_bands(Index height) {
  const Index rows = row_kernel_band_rows(height);
  return (height + rows - 1) / rows;
}

/// Whole bands and the margin, in words.
constexpr Index row_kernel_scratch_words(Index height) {
  return (row_kernel_bands(height) * row_kernel_band_rows(height) + 2 * kMarginRows) * kBlockWords;
}

/// How often a rule is repeated, and what it does at the border.
struct RowKernelOptions {
  const RuntimeRule* rule;  // nullptr for rules that are fixed at compile time
  Border border;
  int max_iterations;
};

/// Repeats a rule until nothing changes or the limit is reached; returns the number of iterations,
/// the last included. Reads `source` and writes `target` once; works in `scratch`,
/// `row_kernel_scratch_words` words on a cache line, of which all beyond the image's own rows must
/// be zero and stay so. Needs width <= kRowKernelWidth.
using RowKernel = int (*)(const RowKernelOptions& options, const ConstBitPlaneView& source,
                          const BitPlaneView& target, std::uint64_t* scratch);

/// Empty where no register holds a row.
struct RowKernels {
  ByRule<RowKernel> by_rule;
  RowKernel runtime;  // takes a RuntimeRule
};

}  // namespace thinbench::detail
