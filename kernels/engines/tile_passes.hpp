// The interface of the tile engine, see tile_grid.hpp. A sub-iteration finds the words of the bit
// set of active tiles, then takes these words in chunks: it lists the tiles of a chunk, visits them
// and records what changed.
#pragma once

#include "core/exported.hpp"
#include "engines/tile_grid.hpp"

namespace thinbench::detail {

struct ConstBytes {
  const std::uint8_t* data = nullptr;
  Index size = 0;
};

/// An ascending list of one or more tiles. The tile after the last one is not visited in this
/// sub-iteration.
struct TileList {
  const std::uint32_t* tiles;  // numbers; kBorderTile is added to those of border tiles
  Index count;
  std::uint64_t* changes;  // output: an entry per tile, see record_changes() in tile_passes.cpp
  std::size_t parity;      // which edges of the grid are read
  ConstBytes ahead;        // prefetched while tiles are visited
};
inline constexpr std::uint32_t kBorderTile = std::uint32_t{1} << 31;

/// Words with active tiles.
struct TileWords {
  const std::uint32_t* words;
  Index count;
};

/// What FindActive needs to know and writes.
struct TileActivation {
  std::size_t sub_iteration;   // the one that follows
  std::size_t sub_iterations;  // per iteration
  std::size_t parity;          // of this one
  Index first_row;             // of tiles
  Index last_row;
  std::uint32_t* words;   // output: the words with active tiles, ascending
  std::uint32_t* before;  // output: the number of active tiles in the words before each
};

/// How many words have active tiles, and how many tiles.
struct ActiveCount {
  Index words;
  Index tiles;
};

/// Finds the tiles in which, or next to which, a pixel changed during the last iteration. Clears
/// the changes of this sub-iteration. The words may have a register more written.
using FindActive = ActiveCount (*)(const TileGridView& grid, const TileActivation& activation);

/// How many words, and tiles in them, were listed.
using ListTiles = ActiveCount (*)(const TileGridView& grid, const TileWords& words,
                                  std::uint32_t* tiles);

/// Adds the changes of the tiles of these words to the bit sets.
using RecordChanges = void (*)(const TileGridView& grid, const TileWords& words,
                               const std::uint64_t* changes, std::size_t parity);

/// Tiles of a chunk, unless no gap between tiles follows; then at most a row of tiles more.
inline constexpr Index kMinChunk = 1024;
/// What may be written or read after the end of lists.
inline constexpr Index kListSlack = 64;

/// Copies the pixels of one row of tiles into the grid and back, and makes all tiles with
/// foreground active. `rows` has the pixels, fewer rows at the lower end of the image.
struct TileLayout {
  TileShape shape;
  void (*load_rows)(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row);
  void (*store_rows)(const TileGridView& grid, const BitPlaneView& rows, Index tile_row);
};
template <>
inline constexpr Features kGainsFrom<TileLayout> = feature("avx2") | feature("avx512bw");

/// The tile engine for one ISA.
struct TileKernels {
  FindActive find_active;
  ListTiles list_tiles;
  RecordChanges record_changes;
};

/// The tile engine for one ISA and rule.
struct TileEngine {
  BoundRule rule;  // with passes on tiles
  const TileKernels* kernels;
  const TileLayout* layout;
};

}  // namespace thinbench::detail
