#include "engines/iterate_tiles.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace thinbench::detail {
namespace {

/// With fewer tiles per thread, barriers cost more than threads gain:
/// docs/experiments.md#threads.
constexpr Index kMinShare = 512;

/// Tiles whose numbers differ by this or more are not neighbours.
std::uint32_t reach_of(const TileGridView& grid) {
  return static_cast<std::uint32_t>(grid.strip_tiles + 2);
}

/// Writes the pending tiles of a range to the grid.
void commit(const TileGridView& grid, const TileRange& range) {
  for (Index i = std::max<Index>(0, range.count - range.delay); i < range.count; ++i) {
    const PendingTile& from = range.pending[i % range.delay];
    std::memcpy(grid.words + Index{range.tiles[i]} * kTileRows, from.words, sizeof(from.words));
  }
}

/// The beginning of one of `parts` equal parts of [0, count).
Index part_begin(Index count, Index part, Index parts) {
  return count * part / parts;
}

}  // namespace

TileWorkspace::TileWorkspace(Index width, Index height, Border border, int threads)
    : grid_(width, height, border), max_delay_(static_cast<Index>(reach_of(grid_.view()))) {
  const Index tiles = grid_.view().groups * kTileGroup;
  const Index shares = tiles < threads * kMinShare ? 1 : threads;
  // A share never needs a larger ring buffer than it has tiles. A single share, which may have all
  // tiles, uses the memory of all shares.
  ring_size_ = std::min(max_delay_, tiles / shares + 1);
  pending_ = make_aligned<PendingTile>(
      static_cast<std::size_t>(std::max(max_delay_, ring_size_ * 2 * shares)));
  const auto list = static_cast<std::size_t>(tiles + shares * kTileGroup);
  lists_[0] = make_aligned<std::uint32_t>(list);
  if (threads > 1) lists_[1] = make_aligned<std::uint32_t>(list);
  listed_ = make_aligned<Index>(static_cast<std::size_t>(shares));
  for (auto& visited : visited_) {
    visited = make_aligned<std::uint64_t>(static_cast<std::size_t>(grid_.group_words()));
  }
}

/// Runs sub-iterations. Each has two barriers: one before tiles are written that other threads may
/// read, one before the next list is used.
class TileIteration {
 public:
  TileIteration(const TileEngine& engine, TileWorkspace& workspace, const ThreadTeam& team)
      : engine_(engine),
        team_(team),
        workspace_(workspace),
        grid_(workspace.grid().view()),
        words_(workspace.grid().group_words()),
        list_(workspace.lists_[0].get()),
        next_list_(team.threads() == 1 ? list_ : workspace.lists_[1].get()),
        visited_(workspace.visited_[0].get()),
        next_visited_(workspace.visited_[1].get()),
        active_(workspace.grid().restart(list_, visited_)),
        delay_(workspace.max_delay_) {}

  [[nodiscard]] bool any_active() const { return active_ != 0; }

  void run(int sub) {
    const Index shares = active_ < team_.threads() * kMinShare ? 1 : team_.threads();
    const Index lists = std::min(shares, words_);
    const TilePass pass = engine_.rule.tile_passes[static_cast<std::size_t>(sub)];
    const BoundScan& scan = engine_.rule.scans[static_cast<std::size_t>(sub)];
    delay_ =
        engine_.kernels->find_delay(list_, active_, reach_of(grid_), delay_, workspace_.max_delay_);
    for_each_share(shares, [&](Index share) {
      if (share != 0) pass(scan, grid_, leading_tiles(share, shares));
      pass(scan, grid_, remaining_tiles(share, shares));
    });
    for_each_share(shares, [&](Index share) {
      if (share != 0) commit(grid_, leading_tiles(share, shares));
      commit(grid_, remaining_tiles(share, shares));
      if (share < lists) {
        workspace_.listed_[static_cast<std::size_t>(share)] = list_share(sub, share, lists);
      }
    });
    join_lists(lists);
    std::swap(list_, next_list_);
    std::swap(visited_, next_visited_);
  }

 private:
  template <class Body>
  void for_each_share(Index shares, const Body& body) const {
    if (shares == 1) return body(Index{0});
    team_.for_ranges(shares, [&](Index first, Index last) {
      for (Index share = first; share < last; ++share) body(share);
    });
  }

  /// The end of a share's leading tiles: those that the thread of an earlier share may read.
  [[nodiscard]] Index leading_end(Index share, Index shares) const {
    const Index first = part_begin(active_, share, shares);
    if (share == 0) return first;
    const Index last = part_begin(active_, share + 1, shares);
    const auto beyond = list_[first] + reach_of(grid_) - 1;
    return std::lower_bound(list_ + first, list_ + last, beyond) - list_;
  }

  /// All of them remain pending until every thread has visited its tiles.
  [[nodiscard]] TileRange leading_tiles(Index share, Index shares) const {
    const Index first = part_begin(active_, share, shares);
    return {list_ + first, leading_end(share, shares) - first, ring(2 * share),
            workspace_.max_delay_};
  }
  /// The last `delay` of them remain pending: the thread of a later share may read them.
  [[nodiscard]] TileRange remaining_tiles(Index share, Index shares) const {
    const Index first = leading_end(share, shares);
    const Index last = part_begin(active_, share + 1, shares);
    return {list_ + first, last - first, ring(shares == 1 ? 0 : 2 * share + 1), delay_};
  }
  /// A ring buffer of `ring_size_` tiles. A single share uses the memory of all rings as one.
  [[nodiscard]] PendingTile* ring(Index index) const {
    return workspace_.pending_.get() + index * workspace_.ring_size_;
  }

  /// Where a share begins to list the next tiles: with room for all tiles of its groups, and for
  /// the entries that ListActive may overwrite.
  [[nodiscard]] std::uint32_t* list_of_share(Index share, Index shares) const {
    const Index tiles = part_begin(words_, share, shares) * kWordBits * kTileGroup;
    return next_list_ + tiles + share * kTileGroup;
  }
  [[nodiscard]] Index list_share(int sub, Index share, Index shares) const {
    return engine_.kernels->list_active(
        grid_, {sub, static_cast<int>(engine_.rule.sub_iterations),
                part_begin(words_, share, shares), part_begin(words_, share + 1, shares), visited_,
                next_visited_, list_of_share(share, shares)});
  }
  /// Moves the lists of all shares together.
  void join_lists(Index shares) {
    active_ = workspace_.listed_[0];
    for (Index share = 1; share < shares; ++share) {
      const std::uint32_t* from = list_of_share(share, shares);
      const Index count = workspace_.listed_[static_cast<std::size_t>(share)];
      std::copy(from, from + count, next_list_ + active_);
      active_ += count;
    }
  }

  const TileEngine& engine_;
  const ThreadTeam& team_;
  TileWorkspace& workspace_;
  const TileGridView& grid_;
  Index words_;
  std::uint32_t* list_;
  std::uint32_t* next_list_;
  std::uint64_t* visited_;
  std::uint64_t* next_visited_;
  Index active_;
  Index delay_;
};

int iterate_tiles(const TileEngine& engine, int max_iterations, TileWorkspace& workspace,
                  const ThreadTeam& team) {
  TileIteration iteration(engine, workspace, team);
  int iterations = 0;
  do {
    for (int sub = 0; sub < static_cast<int>(engine.rule.sub_iterations); ++sub) {
      iteration.run(sub);
    }
    ++iterations;
  } while (iteration.any_active() && iterations < max_iterations);
  return iterations;
}

}  // namespace thinbench::detail
