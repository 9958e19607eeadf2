// Iterates the tile engine over its lists of active tiles.
#pragma once

#include <array>

#include "core/thread_team.hpp"
#include "engines/tile_passes.hpp"

namespace thinbench::detail {

/// The memory of iterate_tiles(): the grid, the lists of active tiles and the pending tiles. A
/// share is one thread's part of a list.
class TileWorkspace {
 public:
  TileWorkspace(Index width, Index height, Border border, int threads);

  [[nodiscard]] TileGrid& grid() { return grid_; }

 private:
  friend class TileIteration;

  TileGrid grid_;
  Index max_delay_;
  Index ring_size_ = 0;                // tiles per ring buffer
  AlignedArray<PendingTile> pending_;  // two ring buffers per share
  AlignedArray<Index> listed_;         // number of tiles listed, by share
  // For the current and the next sub-iteration; one thread uses a single list.
  std::array<AlignedArray<std::uint32_t>, 2> lists_;
  std::array<AlignedArray<std::uint64_t>, 2> visited_;
};

/// Iterates the engine's sub-iterations on the pixels in the grid, in place, until an iteration
/// changes nothing or `max_iterations` is reached; returns the number of iterations, including the
/// last. The workspace must be constructed for at least the team's number of threads. Does not
/// allocate.
int iterate_tiles(const TileEngine& engine, int max_iterations, TileWorkspace& workspace,
                  const ThreadTeam& team);

}  // namespace thinbench::detail
