// Sub-iterations on tiles of 16 x 32 packed pixels, only those within one pixel of which something
// changed since the sub-iteration last ran. Compiled once for every ISA.
//
// Cost per tile at AVX-512: 9 loads, 6 of them across cache lines, 6 funnel shifts, the rule's
// gates, 1 to notice change, 3 for its flags, 1 store to where it waits and 1 load and 1 store from
// there to the grid; a rule of two stages takes 16 funnel shifts and 15 loads, of which GCC
// makes 20. An image is in the grid once: new pixels wait until no neighbour needs the old ones. As
// few wait as the list allows: with room for the densest list, 32 KB for 4,120 rows, they pushed
// the grid out of the first cache, and Zhang-Suen's rule took 14 % longer on deep strokes.
//
// It visits 8,613 tiles of the test image with Guo-Hall's rule, where the row kernel visits 18,228
// rows of as many pixels, but a tile costs twice as much: 17 cycles in the first cache, where the
// instructions alone are 10, stores 3 and loads across lines 2. It wins where strokes are deep or
// images large: most tiles are quiet then.
//
// Measured, not adopted: docs/experiments.md#tiles.
#include "thinning/engines/tile_passes.hpp"

#include <algorithm>

#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/sweep.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using Rows = Lanes32;   // a row of a tile in each lane
using Flags = Lanes16;  // a tile in each lane
constexpr Index kRowLanes = static_cast<Index>(Rows::size);
constexpr Index kFlagLanes = static_cast<Index>(Flags::size);
constexpr std::uint16_t kFirstRow = 1;
constexpr std::uint16_t kLastRow = 0x8000;

/// What a rule sees: row y is the register that begins y rows further down.
struct RowsOfTile {
  const std::uint32_t* words;
  Index strip;

  [[gnu::always_inline]] RowOfThree<Rows> row(Index y) const {
    const std::uint32_t* at = words + y;
    const Rows centre = Rows::load_unaligned(at);
    return {west_neighbour<1>(centre, Rows::load_unaligned(at - strip)), centre,
            east_neighbour<1>(centre, Rows::load_unaligned(at + strip))};
  }

  template <class Rule>
  [[gnu::always_inline]] RowOfThree<Rows> features(Index y, const RowOfThree<Rows>& above,
                                                   const RowOfThree<Rows>& here,
                                                   const RowOfThree<Rows>& below) const {
    const std::uint32_t* at = words + y;
    return features_beside<Rule>(above, here, below,
                                 west_neighbour<2>(here.centre, Rows::load_unaligned(at - strip)),
                                 east_neighbour<2>(here.centre, Rows::load_unaligned(at + strip)));
  }
};

/// What changed in the rows of one register, see TileGridView.
struct ChangedRows {
  std::uint32_t anywhere, west, east;
};

[[gnu::always_inline]] inline ChangedRows changed_rows(Rows before, Rows after) {
  const Rows changed = before ^ after;
  return {nonzero_lanes(changed), lowest_bits(changed), highest_bits(changed)};
}

/// A window would do for every rule; without one GCC finds more in registers below AVX-512, and the
/// printed rule takes 14 % less time with SSE2.
template <class Rule, int sub>
[[gnu::always_inline]] inline Rows next_rows(const RowsOfTile& rows) {
  if constexpr (TwoStageRule<Rule>) {
    return Window<Rule, RowsOfTile>(rows, 0).template next<sub>(Rule{}, rows, 0);
  } else {
    return Rule{}.template next<sub>(neighbourhood(rows.row(-1), rows.row(0), rows.row(1)));
  }
}

template <class Rule, int sub>
[[gnu::always_inline]] inline ChangedRows visit_tile(const std::uint32_t* tile, Index strip,
                                                     PendingTile& pending) {
  ChangedRows all{};
  for (Index row = 0; row < kTileRows; row += kRowLanes) {
    const RowsOfTile rows = {tile + row, strip};
    const Rows before = Rows::load_unaligned(rows.words);
    const Rows next = next_rows<Rule, sub>(rows);
    next.store_aligned(pending.words + row);
    const ChangedRows some = changed_rows(before, next);
    all.anywhere |= some.anywhere << row;
    all.west |= some.west << row;
    all.east |= some.east << row;
  }
  return all;
}

/// Outermost pixels of the image within a tile.
struct BorderOfTile {
  std::uint32_t columns;  // in every row
  std::uint32_t rows;     // bit a row: all of it
};

inline BorderOfTile border_of(const TileGridView& grid, Index tile) {
  const Index x = (tile / grid.strip_tiles - 1) * kTileColumns;
  const Index y = tile % grid.strip_tiles * kTileRows;
  const auto bit = [](Index at, Index size) {
    return 0 <= at && at < size ? std::uint32_t{1} << at : 0;
  };
  return {bit(-x, kTileColumns) | bit(grid.width - 1 - x, kTileColumns),
          bit(-y, kTileRows) | bit(grid.height - 1 - y, kTileRows)};
}

/// As visit_tile, for a tile with pixels that keep their values; few tiles are.
template <class Rule, int sub>
[[gnu::noinline]] ChangedRows visit_border_tile(const TileGridView& grid, Index tile,
                                                PendingTile& pending) {
  const std::uint32_t* before = grid.words + tile * kTileRows;
  static_cast<void>(visit_tile<Rule, sub>(before, grid.strip_tiles * kTileRows, pending));
  const BorderOfTile border = border_of(grid, tile);
  ChangedRows all{};
  for (Index row = 0; row < kTileRows; ++row) {
    const std::uint32_t fixed = (border.rows >> row & 1) != 0 ? ~std::uint32_t{0} : border.columns;
    std::uint32_t& next = pending.words[row];
    next |= before[row] & fixed;
    const std::uint32_t changed = before[row] ^ next;
    all.anywhere |= std::uint32_t{changed != 0} << row;
    all.west |= (changed & 1) << row;
    all.east |= (changed >> (kTileColumns - 1)) << row;
  }
  return all;
}

template <class Rule, int sub, bool has_border>
[[gnu::always_inline]] inline void visit_tiles(const TileGridView& shared,
                                               const TileVisits& visits) {
  const TileGridView grid = shared;  // a store could otherwise be taken to change its fields
  const Index strip = grid.strip_tiles * kTileRows;
  PendingTile* pending = visits.pending;
  PendingTile* const pending_end = pending + visits.kept;
  const auto next_pixels = [&](Index tile) __attribute__((always_inline)) {
    if constexpr (has_border) {
      if ((grid.border_tiles[tile / kTileGroup] >> (tile % kTileGroup) & 1) != 0) {
        return visit_border_tile<Rule, sub>(grid, tile, *pending);
      }
    }
    return visit_tile<Rule, sub>(grid.words + tile * kTileRows, strip, *pending);
  };
  const auto visit = [&](Index tile) __attribute__((always_inline)) {
    const ChangedRows changed = next_pixels(tile);
    grid.changed_rows[tile] = static_cast<std::uint16_t>(changed.anywhere);
    grid.changed_west[tile] = static_cast<std::uint16_t>(changed.west);
    grid.changed_east[tile] = static_cast<std::uint16_t>(changed.east);
    ++pending;
    if (pending == pending_end) pending = visits.pending;
  };
  const auto commit = [&](Index tile) __attribute__((always_inline)) {
    std::uint32_t* to = grid.words + tile * kTileRows;
    for (Index row = 0; row < kTileRows; row += kRowLanes) {
      Rows::load_aligned(pending->words + row).store_aligned(to + row);
    }
  };
  const std::uint32_t* const end = visits.tiles + visits.count;
  const std::uint32_t* next = visits.tiles;
  for (const auto* first = next + std::min(visits.count, visits.kept); next != first; ++next) {
    visit(*next);
  }
  for (const std::uint32_t* last = visits.tiles; next != end; ++next, ++last) {
    commit(*last);
    visit(*next);
  }
}

/// Tiles of a group whose pixels, or pixels beside them, changed; enough for rules of two stages,
/// too, see TwoStageRule.
[[gnu::always_inline]] inline std::uint32_t wanted_tiles(const TileGridView& grid, Index first) {
  const auto any_of = [&](Index tile) {
    return Flags::load_unaligned(grid.changed_rows + tile) |
           Flags::load_unaligned(grid.changed_west + tile + grid.strip_tiles) |
           Flags::load_unaligned(grid.changed_east + tile - grid.strip_tiles);
  };
  std::uint32_t wanted = 0;
  for (Index part = 0; part < kTileGroup; part += kFlagLanes) {
    const Index tile = first + part;
    const Flags any =
        any_of(tile) | (any_of(tile - 1) & Flags(kLastRow)) | (any_of(tile + 1) & Flags(kFirstRow));
    wanted |= nonzero_lanes(any) << part;
  }
  return wanted;
}

[[gnu::always_inline]] inline Index append_tiles(std::uint32_t* list, Index first,
                                                 std::uint32_t tiles) {
  if constexpr (kHasCompress) {
    static_assert(!kHasCompress || 2 * kRowLanes == kTileGroup);
    const Lanes32 low = lane_numbers() + Lanes32(static_cast<std::uint32_t>(first));
    store_compressed(list, low, tiles);
    store_compressed(list + __builtin_popcount(tiles & 0xFFFF), low + Lanes32(16), tiles >> 16);
  } else {
    for (std::uint32_t left = tiles; left != 0; left &= left - 1) {
      *list++ = static_cast<std::uint32_t>(first + __builtin_ctz(left));
    }
  }
  return __builtin_popcount(tiles);
}

/// Bits [64 i + offset, 64 i + offset + 64) of a bit set of `words` words; zeros outside.
std::uint64_t bits_from(const std::uint64_t* bits, Index words, Index i, Index offset) {
  const Index from = i * kWordBits + offset;
  const Index word = from >> 6;
  const Index shift = from & 63;
  const auto at = [&](Index w) { return 0 <= w && w < words ? bits[w] : 0; };
  return shift == 0 ? at(word) : at(word) >> shift | at(word + 1) << (kWordBits - shift);
}

/// Occupied groups of a word in whose reach tiles were visited: only they can hold active tiles.
std::uint64_t candidates(const TileGridView& grid, const std::uint64_t* visited, Index i) {
  const Index strip = grid.strip_tiles / kTileGroup;  // rounded down
  const Index words = (grid.groups + kWordBits - 1) / kWordBits;
  std::uint64_t near = 0;
  for (const Index column : {-strip - 1, -strip, Index{0}, strip, strip + 1}) {
    for (const Index row : {-1, 0, 1}) near |= bits_from(visited, words, i, column + row);
  }
  return near & grid.occupied_groups[i];
}

/// Every tile that changed is in the next list, so its flags are written again, and those of a tile
/// that is left out are zero since its last visit: a list may not leave out more.
Index list_active(const TileGridView& shared_grid, const TileListing& shared_listing) {
  const TileGridView grid = shared_grid;  // stores could otherwise be taken to change the fields
  const TileListing listing = shared_listing;
  std::uint32_t* const wanted_now = grid.wanted[static_cast<std::size_t>(listing.step)];
  const std::uint32_t* earlier_wanted[kMaxSubIterations];
  for (int back = 1; back < listing.length; ++back) {
    const int step = (listing.step + back) % listing.length;
    earlier_wanted[back] = grid.wanted[static_cast<std::size_t>(step)];
  }
  Index count = 0;
  for (Index i = listing.first_word; i < listing.last_word; ++i) {
    std::uint64_t visited = 0;
    for (std::uint64_t left = candidates(grid, listing.visited, i); left != 0; left &= left - 1) {
      const Index group = i * kWordBits + __builtin_ctzll(left);
      std::uint32_t active = wanted_tiles(grid, group * kTileGroup);
      wanted_now[group] = active;
      for (int back = 1; back < listing.length; ++back) {
        active |= earlier_wanted[back][group];
      }
      active &= grid.occupied[group];
      count += append_tiles(listing.list + count, group * kTileGroup, active);
      visited |= std::uint64_t{active != 0} << (group % kWordBits);  // a branch would be a toss-up
    }
    listing.next_visited[i] = visited;
  }
  return count;
}

/// Whether entries `apart` places from each other are `reach` tiles or more from each other.
bool all_lie_apart(const std::uint32_t* tiles, Index count, std::uint32_t reach, Index apart) {
  constexpr Index looked_at_together = 512;
  for (Index begin = 0; begin + apart < count; begin += looked_at_together) {
    const Index end = std::min(begin + looked_at_together, count - apart);
    std::uint32_t near = 0;
    for (Index i = begin; i < end; ++i) near |= tiles[i + apart] - tiles[i] < reach ? 1 : 0;
    if (near != 0) return false;
  }
  return true;
}

Index find_held(const std::uint32_t* tiles, Index count, std::uint32_t reach, Index guess,
                Index most) {
  constexpr Index few = 64;  // 4 KB
  if (most <= few) return most;
  Index kept = std::clamp(guess, few / 2, most);
  while (kept < most && !all_lie_apart(tiles, count, reach, kept)) {
    kept = std::min(most, kept + kept / 8 + 1);
  }
  for (Index fewer = kept - kept / 8 - 1; fewer >= few / 2; fewer = kept - kept / 8 - 1) {
    if (!all_lie_apart(tiles, count, reach, fewer)) break;
    kept = fewer;
  }
  return kept;
}

struct Tiles {
  template <class Rule, int sub>
  static void pass(const TileGridView& grid, const TileVisits& visits) {
    if (grid.border_tiles == nullptr) {
      visit_tiles<Rule, sub, false>(grid, visits);
    } else {
      visit_tiles<Rule, sub, true>(grid, visits);
    }
  }
};

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const TileKernels Exported<TileKernels, kThisIsa>::kKernels = {
    cycles_by_rule<TileVisit, Tiles>(), &list_active, &find_held};

}  // namespace thinbench::detail
