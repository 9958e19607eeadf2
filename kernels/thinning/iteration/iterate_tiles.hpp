// Iterations over the tiles that may still change.
#pragma once

#include <array>

#include "image/thread_team.hpp"
#include "thinning/engines/tile_passes.hpp"

namespace thinbench::detail {

/// Memory of one repetition: the grid, the list of active tiles, and new pixels of tiles that are
/// not written yet.
class TileWorkspace {
 public:
  TileWorkspace(Index width, Index height, Border border, int threads);

  [[nodiscard]] TileGrid& grid() { return grid_; }
  [[nodiscard]] const TileGrid& grid() const { return grid_; }

 private:
  friend class TileIteration;

  TileGrid grid_;
  Index max_held_;
  Index room_ = 0;                     // for so many of them, or all that a share can have
  AlignedArray<PendingTile> pending_;  // twice that room per share
  AlignedArray<Index> listed_;         // by share
  // For the current sub-iteration and the next; one thread uses a single list.
  std::array<AlignedArray<std::uint32_t>, 2> lists_;
  std::array<AlignedArray<std::uint64_t>, 2> visited_;
};

/// Repeats the engine's sub-iterations on the pixels that were loaded into the grid until an
/// iteration changes nothing or the limit is reached; returns the number of iterations, the last
/// included. The workspace was made for as many threads as the team has, or more. No allocation.
int iterate_tiles(const TileEngine& engine, int max_iterations, TileWorkspace& workspace,
                  const ThreadTeam& team);

}  // namespace thinbench::detail
