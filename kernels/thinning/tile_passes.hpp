// The interface of the engine over tiles, see tile_grid.hpp: passes that visit listed tiles.
#pragma once

#include <span>

#include "thinning/passes.hpp"
#include "thinning/tile_grid.hpp"

namespace thinbench {

/// New pixels of a tile, until no neighbour needs the old ones any more.
struct alignas(64) PendingTile {
  std::uint32_t words[kTileRows];
};

/// A range of the active tiles. The last `kept` of them stay pending: more than
/// `TileGridView::strip_tiles` + 1, so that a tile is written when it has no neighbours ahead.
/// `pending` is a ring of `ring` tiles, a power of two and at least `kept`.
struct TileVisits {
  const std::uint32_t* tiles;
  Index count;
  PendingTile* pending;
  Index kept;
  Index ring;
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

/// Lists the tiles in whose reach something changed; returns how many.
using ListActive = Index (*)(const TileGridView& grid, const TileListing& listing);

/// Pixels of one row of tiles, into the grid and back: `rows` are its rows of pixels, kTileRows
/// except at the lower end of the image. Loading leaves in `changed_rows` which tiles have dark
/// pixels, for TileGrid::begin.
struct TileLayout {
  void (*load_rows)(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row);
  void (*store_rows)(const TileGridView& grid, const BitPlaneView& rows, Index tile_row);
};

/// What iterates over tiles: the sub-iterations of a rule at one level.
struct TileEngine {
  std::span<const TileVisit> cycle;
  const ListActive* list_active;
  const TileLayout* layout;
};

/// Compiled once for every instruction-set level.
template <Isa isa>
struct TilePasses {
  static const StepTable<TileVisit> kTable;

  static const ListActive kListActive;

  static const TileLayout kLayout;
};

}  // namespace thinbench
