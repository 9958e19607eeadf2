// The interface of the engine over tiles, see tile_grid.hpp: passes that visit listed tiles.
#pragma once

#include <span>

#include "thinning/engines/passes.hpp"
#include "thinning/engines/tile_grid.hpp"

namespace thinbench::detail {

/// New pixels of a tile, until no neighbour needs the old ones any more.
struct alignas(64) PendingTile {
  std::uint32_t words[kTileRows];
};

/// A range of the active tiles. A tile is written, `kept` visits later, when it has no neighbours
/// ahead; `pending` has room for as many.
struct TileVisits {
  const std::uint32_t* tiles;
  Index count;
  PendingTile* pending;  // of entry i at i modulo `kept`
  Index kept;
};

/// Applies one sub-iteration to the tiles of a range and notes what changed. The last `kept`
/// of them are left to commit().
using TileVisit = void (*)(const TileGridView& grid, const TileVisits& visits);

/// Where to look for tiles that the next step must visit, and where to list them.
struct TileListing {
  int step;  // the one that ran, of a cycle of `length`
  int length;
  Index first_word;              // of the bit sets with a bit a group
  Index last_word;               // the word after the last
  const std::uint64_t* visited;  // groups that the step visited, all of them
  std::uint64_t* next_visited;   // those of the list, in the words asked for
  std::uint32_t* list;           // ascending; kTileGroup entries behind the last may be written
};

/// Lists the tiles within one pixel of which something changed; returns how many.
using ListActive = Index (*)(const TileGridView& grid, const TileListing& listing);

/// How many tiles of an ascending list must wait so that each waits while a tile ahead is its
/// neighbour: entries so far apart differ by `reach` or more, which is positive. At most an eighth
/// more than the least that would do, but not below a number that is small enough for any list; at
/// most `most`, which is always enough. A guess near the result saves time.
using FindHeld = Index (*)(const std::uint32_t* tiles, Index count, std::uint32_t reach,
                           Index guess, Index most);

/// Pixels of one row of tiles, into the grid and back: `rows` are its rows of pixels, kTileRows
/// except at the lower end of the image. Loading leaves in `changed_rows` which tiles have dark
/// pixels, for TileGrid::begin.
struct TileLayout {
  void (*load_rows)(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row);
  void (*store_rows)(const TileGridView& grid, const BitPlaneView& rows, Index tile_row);
};

/// What iterates over tiles at one ISA.
struct TileKernels {
  ByRule<Cycle<TileVisit>> by_rule;
  ListActive list_active;
  FindHeld find_held;
};

/// A rule's sub-iterations, and all that is the same for every rule.
struct TileEngine {
  std::span<const TileVisit> cycle;
  const TileKernels* kernels;
  const TileLayout* layout;
};

}  // namespace thinbench::detail
