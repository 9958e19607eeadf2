#include "engines/iterate_tiles.hpp"

#include <algorithm>

namespace thinbench::detail {
namespace {

/// With fewer rows of tiles per thread, all tiles together, barriers cost more than threads gain:
/// docs/experiments.md#threads.
constexpr Index kMinShareRows = 8192;

}  // namespace

TileWorkspace::TileWorkspace(Index width, Index height, Border border, int threads,
                             const TileShape& shape)
    : grid_(width, height, border, shape) {
  const TileGridView& grid = grid_.view();
  const Index words = grid.tile_rows * grid.row_words;
  words_ = make_aligned<std::uint32_t>(static_cast<std::size_t>(words + kListSlack));
  before_ = make_aligned<std::uint32_t>(static_cast<std::size_t>(words + kListSlack));
  const Index tiles =
      std::min(kMinChunk + grid.stride, grid.tile_rows * grid.stride) + 2 * kListSlack;
  chunks_.resize(static_cast<std::size_t>(threads));
  for (Chunk& chunk : chunks_) {
    chunk.tiles = make_aligned<std::uint32_t>(static_cast<std::size_t>(tiles));
    chunk.changes = make_aligned<std::uint64_t>(static_cast<std::size_t>(tiles));
  }
}

/// Runs sub-iterations. Threads share rows of tiles: what they read of each other's tiles, the
/// edges and changes of the sub-iteration before, does not change.
class TileIteration {
 public:
  TileIteration(const TileEngine& engine, TileWorkspace& workspace, const ThreadTeam& team)
      : engine_(engine), team_(team), workspace_(workspace), grid_(workspace.grid()) {}

  /// Returns whether there were active tiles.
  bool run(std::size_t sub) {
    const ActiveCount active = engine_.kernels->find_active(
        grid_, {sub, engine_.rule.sub_iterations, parity_, 0, grid_.tile_rows,
                workspace_.words_.get(), workspace_.before_.get()});
    const Index shares =
        active.tiles * grid_.shape.rows < team_.threads() * kMinShareRows ? 1 : team_.threads();
    if (shares == 1) {
      visit(sub, 0, active.words, 0);
    } else {
      team_.for_ranges(shares, [&](Index first, Index last) {
        for (Index share = first; share < last; ++share) {
          visit(sub, share_begin(share, shares, active), share_begin(share + 1, shares, active),
                share);
        }
      });
    }
    parity_ ^= 1;
    return active.tiles != 0;
  }

 private:
  [[nodiscard]] std::uint32_t row_of(Index i) const {
    return workspace_.words_[static_cast<std::size_t>(i)] /
           static_cast<std::uint32_t>(grid_.row_words);
  }

  /// The first word of a share: the first of a row of tiles, so that about as many tiles are in
  /// each share.
  [[nodiscard]] Index share_begin(Index share, Index shares, const ActiveCount& active) const {
    const std::uint32_t* const before = workspace_.before_.get();
    const Index tiles = active.tiles * share / shares;
    Index i = std::lower_bound(before, before + active.words, tiles) - before;
    while (0 < i && i < active.words && row_of(i) == row_of(i - 1)) ++i;
    return i;
  }

  void visit(std::size_t sub, Index first, Index last, Index share) const {
    const TilePass pass = engine_.rule.tile_passes[sub];
    const BoundScan& scan = engine_.rule.scans[sub];
    const TileWorkspace::Chunk& chunk = workspace_.chunks_[static_cast<std::size_t>(share)];
    const std::uint32_t* const words = workspace_.words_.get();
    while (first < last) {
      const ActiveCount listed =
          engine_.kernels->list_tiles(grid_, {words + first, last - first}, chunk.tiles.get());
      pass(scan, grid_, {chunk.tiles.get(), listed.tiles, chunk.changes.get(), parity_});
      engine_.kernels->record_changes(grid_, {words + first, listed.words}, chunk.changes.get(),
                                      parity_);
      first += listed.words;
    }
  }

  const TileEngine& engine_;
  const ThreadTeam& team_;
  TileWorkspace& workspace_;
  const TileGridView& grid_;
  std::size_t parity_ = 0;
};

int iterate_tiles(const TileEngine& engine, int max_iterations, TileWorkspace& workspace,
                  const ThreadTeam& team) {
  TileIteration iteration(engine, workspace, team);
  for (int iterations = 0;; ++iterations) {
    const bool active = iteration.run(0);
    if (iterations > 0 && !active) return iterations;
    for (std::size_t sub = 1; sub < engine.rule.sub_iterations; ++sub) iteration.run(sub);
    if (iterations + 1 == max_iterations) return max_iterations;
  }
}

}  // namespace thinbench::detail
