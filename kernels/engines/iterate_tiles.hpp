// Iterates the tile engine over its lists of active tiles.
#pragma once

#include <vector>

#include "core/thread_team.hpp"
#include "engines/tile_passes.hpp"

namespace thinbench::detail {

/// The memory of iterate_tiles(): the grid, the words with active tiles and, for each thread, the
/// tiles of a chunk and what changed in them.
class TileWorkspace {
 public:
  TileWorkspace(Index width, Index height, Border border, int threads, const TileShape& shape);

  [[nodiscard]] const TileGridView& grid() const { return grid_.view(); }

 private:
  friend class TileIteration;

  struct Chunk {
    AlignedArray<std::uint32_t> tiles;
    AlignedArray<std::uint64_t> changes;
  };

  TileGrid grid_;
  AlignedArray<std::uint32_t> words_;
  AlignedArray<std::uint32_t> before_;
  std::vector<Chunk> chunks_;
};

/// Iterates the engine's sub-iterations on the pixels in the grid, in place, until an iteration
/// changes nothing or `max_iterations` is reached; returns the number of iterations, including the
/// last. The workspace must be constructed for at least the team's number of threads. Does not
/// allocate.
int iterate_tiles(const TileEngine& engine, int max_iterations, TileWorkspace& workspace,
                  const ThreadTeam& team);

}  // namespace thinbench::detail
