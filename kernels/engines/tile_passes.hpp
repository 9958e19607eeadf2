// The interface of the tile engine, see tile_grid.hpp. A TilePass applies one sub-iteration to the
// tiles of a range and records which rows changed; the last `delay` tiles remain pending.
#pragma once

#include "engines/tile_grid.hpp"

namespace thinbench::detail {

/// New pixels of a tile, not written to the grid yet because a neighbour still needs the old ones.
struct alignas(64) PendingTile {
  std::uint32_t words[kTileRows];
};

/// A range of the list of active tiles. A tile is written to the grid `delay` visits after its own,
/// when no neighbour of it remains to be visited.
struct TileRange {
  const std::uint32_t* tiles;
  Index count;
  PendingTile* pending;  // a ring buffer of `delay` tiles: entry i is at i modulo `delay`
  Index delay;
};

/// The input and output of ListActive, which can process parts of the grid in parallel.
struct TileListing {
  int sub_iteration;   // index of the one that just ran
  int sub_iterations;  // per iteration
  Index first_word;    // words [first_word, last_word) of the bit sets of groups
  Index last_word;
  const std::uint64_t* visited;  // all groups that the sub-iteration visited
  std::uint64_t* next_visited;   // output: the groups of the list, in words of the range only
  std::uint32_t* list;           // output, ascending; kTileGroup more entries may be overwritten
};

/// Lists the tiles that the next sub-iteration must visit: the occupied tiles in which, or next to
/// which, a pixel changed during the last iteration. Returns their number.
using ListActive = Index (*)(const TileGridView& grid, const TileListing& listing);

/// A sufficient delay for an ascending list of tiles: tiles[i + delay] - tiles[i] >= reach for all
/// i, so that entries `delay` places apart are not neighbours. `reach` is positive. At most about
/// an eighth above the minimum, unless that is small; at most `max_delay`, which must be
/// sufficient. Fast if `guess` is near the result.
using FindDelay = Index (*)(const std::uint32_t* tiles, Index count, std::uint32_t reach,
                            Index guess, Index max_delay);

/// Copies the pixels of one row of tiles into the grid and back. `rows` has kTileRows rows of
/// pixels, fewer at the lower end of the image. load_rows sets `changed_rows` to nonzero for tiles
/// with foreground, for TileGrid::restart.
struct TileLayout {
  void (*load_rows)(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row);
  void (*store_rows)(const TileGridView& grid, const BitPlaneView& rows, Index tile_row);
};

/// The tile engine for one ISA.
struct TileKernels {
  ListActive list_active;
  FindDelay find_delay;
};

/// The tile engine for one ISA and rule.
struct TileEngine {
  BoundRule rule;  // with passes on tiles
  const TileKernels* kernels;
  const TileLayout* layout;
};

}  // namespace thinbench::detail
