#include "thinning/iteration/iterate_tiles.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace thinbench::detail {
namespace {

/// Tiles per thread below which barriers cost more than threads save:
/// docs/experiments.md#smaller-shares.
constexpr Index kMinShare = 512;

/// The distance from a tile to the first that is no neighbour of it.
std::uint32_t reach_of(const TileGridView& grid) {
  return static_cast<std::uint32_t>(grid.strip_tiles + 2);
}

/// Writes the tiles of a range that are still pending.
void commit(const TileGridView& grid, const TileVisits& visits) {
  for (Index i = std::max<Index>(0, visits.count - visits.kept); i < visits.count; ++i) {
    const PendingTile& from = visits.pending[i % visits.kept];
    std::memcpy(grid.words + Index{visits.tiles[i]} * kTileRows, from.words, sizeof(from.words));
  }
}

/// The beginning of one of `parts` equal parts of [0, count).
Index part_begin(Index count, Index part, Index parts) {
  return count * part / parts;
}

}  // namespace

TileWorkspace::TileWorkspace(Index width, Index height, Border border, int threads)
    : grid_(width, height, border), max_held_(static_cast<Index>(reach_of(grid_.view()))) {
  const Index tiles = grid_.view().groups * kTileGroup;
  const Index shares = tiles < threads * kMinShare ? 1 : threads;
  // A share has no more tiles than its part of the list. A single share, which may be all tiles,
  // has the room of all shares.
  room_ = std::min(max_held_, tiles / shares + 1);
  pending_ =
      make_aligned<PendingTile>(static_cast<std::size_t>(std::max(max_held_, room_ * 2 * shares)));
  const auto list = static_cast<std::size_t>(tiles + shares * kTileGroup);
  lists_[0] = make_aligned<std::uint32_t>(list);
  if (threads > 1) lists_[1] = make_aligned<std::uint32_t>(list);
  listed_ = make_aligned<Index>(static_cast<std::size_t>(shares));
  for (auto& visited : visited_) {
    visited = make_aligned<std::uint64_t>(static_cast<std::size_t>(grid_.group_words()));
  }
}

/// The sub-iterations of one repetition, with two barriers each: one before tiles are written that
/// other threads may have read, one before the next list is used.
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
        active_(workspace.grid().begin(list_, visited_)),
        kept_(workspace.max_held_) {}

  [[nodiscard]] bool any_active() const { return active_ != 0; }

  void run(int sub) {
    const Index shares = active_ < team_.threads() * kMinShare ? 1 : team_.threads();
    const Index lists = std::min(shares, words_);
    const TileVisit visit = engine_.cycle[static_cast<std::size_t>(sub)];
    kept_ =
        engine_.kernels->find_held(list_, active_, reach_of(grid_), kept_, workspace_.max_held_);
    for_each_share(shares, [&](Index share) {
      if (share != 0) visit(grid_, held(share, shares));
      visit(grid_, rest(share, shares));
    });
    for_each_share(shares, [&](Index share) {
      if (share != 0) commit(grid_, held(share, shares));
      commit(grid_, rest(share, shares));
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

  /// The beginning of a share's tiles that no thread of an earlier share may still read.
  [[nodiscard]] Index rest_begin(Index share, Index shares) const {
    const Index first = part_begin(active_, share, shares);
    if (share == 0) return first;
    const Index last = part_begin(active_, share + 1, shares);
    const auto beyond = list_[first] + reach_of(grid_) - 1;
    return std::lower_bound(list_ + first, list_ + last, beyond) - list_;
  }

  /// The tiles before it: written after all threads have visited theirs.
  [[nodiscard]] TileVisits held(Index share, Index shares) const {
    const Index first = part_begin(active_, share, shares);
    return {list_ + first, rest_begin(share, shares) - first, pending_of(2 * share),
            workspace_.max_held_};
  }
  /// The others: written on the way, but for the last `kept`, which a thread of a later share may
  /// read.
  [[nodiscard]] TileVisits rest(Index share, Index shares) const {
    const Index first = rest_begin(share, shares);
    const Index last = part_begin(active_, share + 1, shares);
    return {list_ + first, last - first, pending_of(shares == 1 ? 0 : 2 * share + 1), kept_};
  }
  /// Memory for `room_` tiles; from the first place on, for all that a single share may hold.
  [[nodiscard]] PendingTile* pending_of(Index place) const {
    return workspace_.pending_.get() + place * workspace_.room_;
  }

  /// Each share of the groups has room for all its tiles in the next list, and for entries written
  /// behind the last.
  [[nodiscard]] std::uint32_t* list_of_share(Index share, Index shares) const {
    const Index tiles = part_begin(words_, share, shares) * kWordBits * kTileGroup;
    return next_list_ + tiles + share * kTileGroup;
  }
  [[nodiscard]] Index list_share(int sub, Index share, Index shares) const {
    return engine_.kernels->list_active(
        grid_, {sub, static_cast<int>(engine_.cycle.size()), part_begin(words_, share, shares),
                part_begin(words_, share + 1, shares), visited_, next_visited_,
                list_of_share(share, shares)});
  }
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
  Index kept_;
};

int iterate_tiles(const TileEngine& engine, int max_iterations, TileWorkspace& workspace,
                  const ThreadTeam& team) {
  TileIteration iteration(engine, workspace, team);
  int iterations = 0;
  do {
    for (int sub = 0; sub < static_cast<int>(engine.cycle.size()); ++sub) iteration.run(sub);
    ++iterations;
  } while (iteration.any_active() && iterations < max_iterations);
  return iterations;
}

}  // namespace thinbench::detail
