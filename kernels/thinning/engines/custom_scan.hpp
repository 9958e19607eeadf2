// How engines run custom rules: by scan functions, each one sub-iteration on a column of registers.
// Plain data, safe to include in files of every ISA.
#pragma once

#include <array>
#include <cstdint>

#include "image/plane_view.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

/// What a register holds, and where the west and east neighbours of its pixels are.
enum class Layout : std::uint8_t {
  words,      // part of a row of a plane; neighbours across words are in memory
  row,        // a whole row of up to 512 pixels
  lanes_32,   // a row of an image per lane
  lanes_64,   //
  lanes_128,  // a row of an image per pair of 64-bit lanes
  tiles,      // a row of a tile per 32-bit lane; all neighbours are in memory
};
inline constexpr int kLayouts = 6;

/// Rows of registers, one below the other. Row -1 and the row after the last are readable. The
/// target is the source, or does not overlap with it. Of tiles, each register has several rows.
struct ColumnScan {
  const void* source;   // row 0
  Index source_stride;  // bytes
  void* target;
  Index target_stride;
  Index rows;
  Index band_rows;        // of these, in at most 64 bands; the last band may have fewer
  const void* fixed;      // a register with a 1 for every pixel that must not change, or nullptr
  Index side_stride = 0;  // tiles: bytes from a tile to its eastern neighbour
};

/// Returns the bit set of bands in which a pixel changed.
using ScanFunction = std::uint64_t (*)(const void* program, const ColumnScan& scan);

/// A scan function with the program that it executes.
struct BoundScan {
  ScanFunction function = nullptr;
  const void* program = nullptr;

  std::uint64_t operator()(const ColumnScan& scan) const { return function(program, scan); }
};

/// A custom rule, ready to run on one ISA and layout.
struct BoundRule : RuntimeRule {
  std::array<BoundScan, kMaxSubIterations> scans = {};
  int sub_iterations = 0;
  Index register_words = 1;
};

}  // namespace thinbench::detail
