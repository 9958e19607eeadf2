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

std::uint32_t TileIteration::row_of(Index i) const {
  return workspace_.words_[static_cast<std::size_t>(i)] /
         static_cast<std::uint32_t>(grid_.row_words);
}

/// The first word of a share: the first of a row of tiles, so that about as many tiles are in each
/// share.
Index TileIteration::share_begin(Index share, Index shares, const ActiveCount& active) const {
  const std::uint32_t* const before = workspace_.before_.get();
  const Index tiles = active.tiles * share / shares;
  Index i = std::lower_bound(before, before + active.words, tiles) - before;
  while (0 < i && i < active.words && row_of(i) == row_of(i - 1)) ++i;
  return i;
}

void TileIteration::visit_words(Index number, Index first, Index last, Index share,
                                ConstBytes ahead) const {
  const std::size_t sub = static_cast<std::size_t>(number) % engine_.rule.sub_iterations;
  const std::size_t parity = static_cast<std::size_t>(number) % 2;
  const TilePass pass = engine_.rule.tile_passes[sub];
  const BoundScan& scan = engine_.rule.scans[sub];
  const TileWorkspace::Chunk& chunk = workspace_.chunks_[static_cast<std::size_t>(share)];
  const std::uint32_t* const words = workspace_.words_.get();
  while (first < last) {
    const ActiveCount listed =
        engine_.kernels->list_tiles(grid_, {words + first, last - first}, chunk.tiles.get());
    pass(scan, grid_, {chunk.tiles.get(), listed.tiles, chunk.changes.get(), parity, ahead});
    ahead = {};  // rows of tiles of several chunks are rare
    engine_.kernels->record_changes(grid_, {words + first, listed.words}, chunk.changes.get(),
                                    parity);
    first += listed.words;
  }
}

bool TileIteration::visit_rows(Index number, Index first_row, Index last_row,
                               const ConstBytes& ahead) {
  const std::size_t subs = engine_.rule.sub_iterations;
  const std::size_t sub = static_cast<std::size_t>(number) % subs;
  const ActiveCount active = engine_.kernels->find_active(
      grid_, {sub, subs, static_cast<std::size_t>(number) % 2, first_row, last_row,
              workspace_.words_.get(), workspace_.before_.get()});
  const Index shares =
      active.tiles * grid_.shape.rows < team_.threads() * kMinShareRows ? 1 : team_.threads();
  if (shares == 1) {
    visit_words(number, 0, active.words, 0, ahead);
  } else {
    team_.for_ranges(shares, [&](Index first, Index last) {
      for (Index share = first; share < last; ++share) {
        visit_words(number, share_begin(share, shares, active),
                    share_begin(share + 1, shares, active), share);
      }
    });
  }
  return active.tiles != 0;
}

int TileIteration::run(int max_iterations) {
  const auto subs = static_cast<Index>(engine_.rule.sub_iterations);
  for (;; ++done_) {
    const bool begins = done_ % subs == 0;
    const auto iterations = static_cast<int>(done_ / subs);
    if (begins && iterations == max_iterations) return max_iterations;
    const bool active = visit_rows(done_, 0, grid_.tile_rows);
    if (begins && iterations > 0 && !active) return iterations;
  }
}

}  // namespace thinbench::detail
