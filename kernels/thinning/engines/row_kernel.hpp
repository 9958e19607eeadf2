// Whole-image kernels for images up to 512 pixels wide: one register holds a row.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/options.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

inline constexpr Index kRowKernelWidth = 512;

/// Rows are grouped in at most 64 bands of at least 8 rows, so that a word is a bit set of bands.
constexpr Index row_kernel_band_rows(Index height) {
  constexpr Index min_rows = 8;
  return height <= 64 * min_rows ? min_rows : (height + 63) / 64;
}

constexpr Index row_kernel_bands(Index height) {
  const Index rows = row_kernel_band_rows(height);
  return (height + rows - 1) / rows;
}

/// Whole bands and the margins, in words.
constexpr Index row_kernel_scratch_words(Index height) {
  return (row_kernel_bands(height) * row_kernel_band_rows(height) + 2 * kMarginRows) * kBlockWords;
}

struct RowKernelOptions {
  const RuntimeRule* rule;  // nullptr for built-in rules
  Border border;
  int max_iterations;
};

/// Iterates a rule until nothing changes or `max_iterations` is reached; returns the number of
/// iterations, including the last. Reads `source` and writes `target` once. `scratch` has
/// row_kernel_scratch_words() words, aligned to a cache line; words outside the image's rows must
/// be zero and are zero on return. Requires width <= kRowKernelWidth.
using RowKernel = int (*)(const RowKernelOptions& options, const ConstBitPlaneView& source,
                          const BitPlaneView& target, std::uint64_t* scratch);

/// All nullptr if the ISA has no 512-bit registers.
struct RowKernels {
  ByRule<RowKernel> by_rule;
  RowKernel custom;  // requires a BoundRule
};

}  // namespace thinbench::detail
