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

/// Makes the list of the next step from what step `step` of a cycle of `length` changed; returns
/// its length.
using ListActive = Index (*)(const TileGridView& grid, int step, int length);

/// What iterates over tiles: the sub-iterations of a rule at one level.
struct TileEngine {
  std::span<const TileVisit> cycle;
  const ListActive* list_active;
};

/// Compiled once for every instruction-set level.
template <Isa isa>
struct TilePasses {
  static const StepTable<TileVisit> kTable;

  static const ListActive kListActive;
};

}  // namespace thinbench
