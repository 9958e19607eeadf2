// Iterates the tile engine over its lists of active tiles.
#pragma once

#include <algorithm>
#include <vector>

#include "core/thread_team.hpp"
#include "engines/tile_passes.hpp"

namespace thinbench::detail {

/// The memory of a TileIteration: the grid, the words with active tiles and, for each thread, the
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

/// Sub-iterations of the first iteration that run while rows of tiles are loaded. With more, noise
/// loses what thin strokes gain: docs/experiments.md#tiles.
inline constexpr Index kFusedSubIterations = 2;

/// Iterates the engine's sub-iterations on the pixels in the grid, in place. Threads share rows of
/// tiles: what they read of each other's tiles, the edges and changes of the sub-iteration before,
/// does not change. The workspace must be constructed for at least the team's number of threads.
/// Does not allocate.
class TileIteration {
 public:
  TileIteration(const TileEngine& engine, TileWorkspace& workspace, const ThreadTeam& team)
      : engine_(engine), team_(team), workspace_(workspace), grid_(workspace.grid()) {}

  /// Loads all rows of tiles by `load(tile_row)`. Meanwhile it runs the first sub-iterations, each
  /// one row of tiles behind what it reads, and prefetches the next row from `memory(tile_row)`.
  template <class Load, class Memory>
  void run_while_loading(const Load& load, const Memory& memory) {
    const auto subs = static_cast<Index>(engine_.rule.sub_iterations);
    const Index fused = std::min(kFusedSubIterations, subs);
    for (Index row = 0; row < grid_.tile_rows + fused; ++row) {
      if (row < grid_.tile_rows) load(row);
      const ConstBytes next = row + 1 < grid_.tile_rows ? memory(row + 1) : ConstBytes{};
      const Index part = next.size / fused;
      for (Index sub = 0; sub < fused; ++sub) {
        const Index ready = row - 1 - sub;
        if (ready < 0 || ready >= grid_.tile_rows) continue;
        visit_rows(sub, ready, ready + 1, {next.data + sub * part, part});
      }
    }
    done_ = fused;
  }

  /// Runs the others until an iteration changes nothing or `max_iterations` is reached; returns
  /// the number of iterations, including the last.
  int run(int max_iterations);

 private:
  /// Runs a sub-iteration, counted from the first iteration on, on rows of tiles. Returns whether
  /// any were active.
  bool visit_rows(Index number, Index first_row, Index last_row, const ConstBytes& ahead = {});
  void visit_words(Index number, Index first, Index last, Index share, ConstBytes ahead = {}) const;
  [[nodiscard]] std::uint32_t row_of(Index i) const;
  [[nodiscard]] Index share_begin(Index share, Index shares, const ActiveCount& active) const;

  const TileEngine& engine_;
  const ThreadTeam& team_;
  TileWorkspace& workspace_;
  const TileGridView& grid_;
  Index done_ = 0;  // sub-iterations
};

}  // namespace thinbench::detail
