// Repeats the sub-iterations of a rule on the tiles that may still change.
#pragma once

#include "core/thread_team.hpp"
#include "thinning/tile_passes.hpp"

namespace thinbench {

/// Memory of one repetition: the grid and the tiles that are not written yet.
class TileWorkspace {
 public:
  TileWorkspace(Index width, Index height, int threads);

  [[nodiscard]] TileGrid& grid() { return grid_; }
  /// Room for the share of each thread, as many as the workspace was made for, so that none writes
  /// what another still reads.
  [[nodiscard]] PendingTile* pending() { return pending_.get(); }
  [[nodiscard]] Index kept() const { return kept_; }
  [[nodiscard]] Index ring() const { return ring_; }

 private:
  TileGrid grid_;
  Index kept_;
  Index ring_;
  AlignedArray<PendingTile> pending_;
};

/// Repeats a cycle until it changes nothing or `most_cycles` are done; returns how many ran, the
/// last one included. The background goes on outside the image. Reads `source` and writes `target`
/// once. No allocation.
int iterate_tiles(const TileEngine& engine, int most_cycles, const ConstBitPlaneView& source,
                  const BitPlaneView& target, TileWorkspace& workspace, const ThreadTeam& team);

}  // namespace thinbench
