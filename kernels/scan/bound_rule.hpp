// The interface between rules and engines: a rule is a list of scan functions, each of which
// applies one sub-iteration to a column of registers. Plain data, safe to include in files of every
// ISA.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "core/plane_view.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// What a register holds, and where the west and east neighbours of its pixels are.
enum class Layout : std::uint8_t {
  words,      // part of a row of a plane; neighbours across words are in memory
  row,        // a whole row of up to 512 pixels
  lanes_32,   // a row of an image per lane
  lanes_64,   //
  lanes_128,  // a row of an image per pair of 64-bit lanes
  tiles,      // a row of a tile per 32-bit lane, rows above and below in other registers
};
inline constexpr std::size_t kLayouts = 6;

/// Whether scans are in place: the target is the source, and its rows are one register apart.
constexpr bool is_in_place(Layout layout) {
  return layout != Layout::words && layout != Layout::tiles;
}

inline constexpr Index kScannedRegisters = 2;  // of a tile

/// Rows of registers, one below the other. Row -1 and the row after the last are readable, and one
/// more at either end for two-stage rules. The target is the source, or does not overlap with it.
///
/// A tile is one after the other of its registers, each of which has every n-th of its rows; so do
/// row -1, which is the last register with each row moved down by one lane, and the row after the
/// last. What no register has comes from the tiles above and below. Tiles beside it are next to it
/// in memory. Only source, target, above and below have a meaning.
struct ColumnScan {
  const void* source;   // row 0
  Index source_stride;  // bytes
  void* target;
  Index target_stride;
  Index rows;
  Index band_rows;    // of these, in at most 64 bands; the last band may have fewer
  const void* fixed;  // a register with a 1 for every pixel that must not change, or nullptr
  const std::uint32_t* above = nullptr;  // tiles: the last row of the tile above, between those
  const std::uint32_t* below = nullptr;  // of its neighbours; the first row of the tile below
};

/// Returns the bit set of bands in which a pixel changed.
using ScanFunction = std::uint64_t (*)(const void* program, const ColumnScan& scan);

/// A scan function with the program that it executes.
struct BoundScan {
  ScanFunction function = nullptr;
  const void* program = nullptr;

  std::uint64_t operator()(const ColumnScan& scan) const { return function(program, scan); }
};

/// Prefetches memory that will be read and memory that will be written, one cache line at a time.
struct Prefetcher {
  const std::uint8_t* source;
  const std::uint8_t* target;
  Index bytes;
  Index next = 0;

  [[gnu::always_inline]] void prefetch_line() {
    constexpr Index line = 64;
    if (next >= bytes) return;
    __builtin_prefetch(source + next, 0, 2);
    __builtin_prefetch(target + next, 1, 2);
    next += line;
  }
};

/// Applies all sub-iterations to rows in place until an iteration changes nothing or the limit is
/// reached; returns the number of iterations. The scan is one band. Prefetches a line per row. For
/// small images, for which a call for each sub-iteration takes 2 to 20 % longer.
using RepeatFunction = int (*)(const ColumnScan& scan, int max_iterations, Prefetcher& prefetcher);

struct TileGridView;
struct TileList;

/// Applies one sub-iteration to the tiles of a list, see engines/tile_passes.hpp. Compiled from
/// the template of a built-in rule, which ignores `scan`, or one that calls `scan` for each tile.
using TilePass = void (*)(const BoundScan& scan, const TileGridView& grid, const TileList& list);

inline constexpr int kMaxSubIterations = static_cast<int>(Rule::kMaxSubIterations);

/// A rule, ready to run on one ISA and layout: all that engines know of it.
struct BoundRule {
  std::array<BoundScan, kMaxSubIterations> scans = {};
  std::array<TilePass, kMaxSubIterations> tile_passes = {};  // of Layout::tiles
  RepeatFunction repeat = nullptr;                           // of lanes; nullptr: by `scans`
  std::size_t sub_iterations = 0;
  Index register_elements = 1;
  bool adds_pixels = false;                     // else background remains background
  std::shared_ptr<const void> owner = nullptr;  // keeps alive what the scans refer to
};

}  // namespace thinbench::detail
