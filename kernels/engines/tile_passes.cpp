// Sub-iterations on tiles of 16 x 32 packed pixels. Visits only tiles in which, or within one pixel
// of which, something changed since the same sub-iteration last ran. Compiled once for every ISA.
//
// Cost per tile at AVX-512: 9 loads, 6 of them across cache lines, 6 funnel shifts, the rule's
// gates, 1 gate to detect changes, 3 for its flags, 1 store to the pending tiles, then 1 load and 1
// store to copy it to the grid. A two-stage rule takes 16 funnel shifts and 15 loads (20 as
// compiled by GCC).
//
// The grid is updated in place: new pixels are pending until no neighbour needs the old ones. The
// number of pending tiles is adapted to the list. With the ring buffer of the densest list, 32 KB
// for 4,120 rows, the grid was evicted from the L1 cache, and Zhang-Suen took 14 % longer on deep
// strokes.
//
// On the test image with Guo-Hall it visits 8,613 tiles; the row kernel visits 18,228 rows of the
// same size in pixels. But a tile takes twice as long: 17 cycles in the L1 cache, of which
// instructions account for 10, stores for 3 and line-crossing loads for 2. Tiles are faster for
// deep strokes and large images, where most tiles are inactive.
//
// Alternatives not adopted: docs/experiments.md#tiles.
#include "engines/tile_passes.hpp"

#include <algorithm>

#include "core/exported.hpp"
#include "scan/built_in.hpp"
#include "scan/window.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using Rows = Lanes32;   // one row of a tile per lane
using Flags = Lanes16;  // one tile per lane
constexpr Index kRowLanes = static_cast<Index>(Rows::size);
constexpr Index kFlagLanes = static_cast<Index>(Flags::size);
constexpr std::uint16_t kFirstRow = 1;
constexpr std::uint16_t kLastRow = 0x8000;

/// Row access for rules: row(y) has kRowLanes rows of the strip, from y rows below `words`.
struct RowsOfTile {
  const std::uint32_t* words;
  Index strip;

  [[gnu::always_inline]] RowTriple<Rows> row(Index y) const {
    const std::uint32_t* at = words + y;
    const Rows centre = Rows::load_unaligned(at);
    return {west_neighbour<1>(centre, Rows::load_unaligned(at - strip)), centre,
            east_neighbour<1>(centre, Rows::load_unaligned(at + strip))};
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<Rows> features(Index y, const RowTriple<Rows>& above,
                                                  const RowTriple<Rows>& here,
                                                  const RowTriple<Rows>& below) const {
    const std::uint32_t* at = words + y;
    return feature_triple<Rule>(above, here, below,
                                west_neighbour<2>(here.centre, Rows::load_unaligned(at - strip)),
                                east_neighbour<2>(here.centre, Rows::load_unaligned(at + strip)));
  }
};

/// The changed rows of a tile or register as bits, see TileGridView.
struct ChangedRows {
  std::uint32_t anywhere, west, east;
};

[[gnu::always_inline]] inline ChangedRows changed_rows(Rows before, Rows after) {
  const Rows changed = before ^ after;
  return {nonzero_lanes(changed), lowest_bits(changed), highest_bits(changed)};
}

/// A Window would be correct for every rule. Without one GCC keeps more values in registers on ISAs
/// below AVX-512: naccache_shinghal takes 14 % less time with SSE2.
template <class Rule, int sub>
[[gnu::always_inline]] inline Rows next_rows(const RowsOfTile& rows) {
  if constexpr (TwoStageRule<Rule>) {
    return Window<Rule, RowsOfTile>(rows, 0).template next<sub>(Rule{}, rows, 0);
  } else {
    return Rule{}.template next<sub>(neighbourhood(rows.row(-1), rows.row(0), rows.row(1)));
  }
}

/// Computes a tile's new pixels, as visitors do.
template <class NextRows>
[[gnu::always_inline]] inline ChangedRows compute_tile(const std::uint32_t* tile,
                                                       PendingTile& pending,
                                                       const NextRows& next_rows_from) {
  ChangedRows all{};
  for (Index row = 0; row < kTileRows; row += kRowLanes) {
    const Rows before = Rows::load_unaligned(tile + row);
    const Rows next = next_rows_from(row);
    next.store_aligned(pending.words + row);
    const ChangedRows some = changed_rows(before, next);
    all.anywhere |= some.anywhere << row;
    all.west |= some.west << row;
    all.east |= some.east << row;
  }
  return all;
}

/// Visits a tile: writes its new pixels to `pending` and returns what changed.
template <class Rule, int sub>
struct BuiltInVisitor {
  [[gnu::always_inline]] ChangedRows operator()(const std::uint32_t* tile, Index strip,
                                                PendingTile& pending) const {
    return compute_tile(
        tile, pending, [&](Index row) __attribute__((always_inline)) {
          return next_rows<Rule, sub>(RowsOfTile{tile + row, strip});
        });
  }
};

/// The same by a scan function.
struct ScanVisitor {
  const BoundScan& scan;

  [[gnu::always_inline]] ChangedRows operator()(const std::uint32_t* tile, Index strip,
                                                PendingTile& pending) const {
    constexpr auto bytes = static_cast<Index>(sizeof(Rows));
    constexpr Index steps = kTileRows / kRowLanes;
    scan({.source = tile,
          .source_stride = bytes,
          .target = pending.words,
          .target_stride = bytes,
          .rows = steps,
          .band_rows = steps,
          .fixed = nullptr,
          .side_stride = strip * static_cast<Index>(sizeof(std::uint32_t))});
    return compute_tile(
        tile, pending, [&](Index row) __attribute__((always_inline)) {
          return Rows::load_aligned(pending.words + row);
        });
  }
};

/// The border pixels of the image within a tile.
struct BorderOfTile {
  std::uint32_t columns;  // bit set of columns
  std::uint32_t rows;     // bit set of rows
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

/// Visits a tile with border pixels, which it restores. Out of line because such tiles are few.
template <class Visitor>
[[gnu::noinline]] ChangedRows visit_border_tile(const Visitor& visitor, const TileGridView& grid,
                                                Index tile, PendingTile& pending) {
  const std::uint32_t* before = grid.words + tile * kTileRows;
  static_cast<void>(visitor(before, grid.strip_tiles * kTileRows, pending));
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

template <bool has_border, class Visitor>
[[gnu::always_inline]] inline void visit_tiles(const Visitor& visitor, const TileGridView& shared,
                                               const TileRange& range) {
  const TileGridView grid = shared;  // a local copy, which stores cannot alias
  const Index strip = grid.strip_tiles * kTileRows;
  PendingTile* pending = range.pending;
  PendingTile* const pending_end = pending + range.delay;
  const auto next_pixels = [&](Index tile) __attribute__((always_inline)) {
    if constexpr (has_border) {
      if ((grid.border_tiles[tile / kTileGroup] >> (tile % kTileGroup) & 1) != 0) {
        return visit_border_tile(visitor, grid, tile, *pending);
      }
    }
    return visitor(grid.words + tile * kTileRows, strip, *pending);
  };
  const auto visit = [&](Index tile) __attribute__((always_inline)) {
    const ChangedRows changed = next_pixels(tile);
    grid.changed_rows[tile] = static_cast<std::uint16_t>(changed.anywhere);
    grid.changed_west[tile] = static_cast<std::uint16_t>(changed.west);
    grid.changed_east[tile] = static_cast<std::uint16_t>(changed.east);
    ++pending;
    if (pending == pending_end) pending = range.pending;
  };
  const auto commit = [&](Index tile) __attribute__((always_inline)) {
    std::uint32_t* to = grid.words + tile * kTileRows;
    for (Index row = 0; row < kTileRows; row += kRowLanes) {
      Rows::load_aligned(pending->words + row).store_aligned(to + row);
    }
  };
  const std::uint32_t* const end = range.tiles + range.count;
  const std::uint32_t* next = range.tiles;
  for (const auto* first = next + std::min(range.count, range.delay); next != first; ++next) {
    visit(*next);
  }
  for (const std::uint32_t* oldest = range.tiles; next != end; ++next, ++oldest) {
    commit(*oldest);
    visit(*next);
  }
}

/// Tiles of a group in which, or next to which, a pixel changed in the last sub-iteration. Correct
/// for two-stage rules too, see TwoStageRule.
[[gnu::always_inline]] inline std::uint32_t tiles_near_changes(const TileGridView& grid,
                                                               Index first) {
  const auto any_of = [&](Index tile) {
    return Flags::load_unaligned(grid.changed_rows + tile) |
           Flags::load_unaligned(grid.changed_west + tile + grid.strip_tiles) |
           Flags::load_unaligned(grid.changed_east + tile - grid.strip_tiles);
  };
  std::uint32_t tiles = 0;
  for (Index part = 0; part < kTileGroup; part += kFlagLanes) {
    const Index tile = first + part;
    const Flags any =
        any_of(tile) | (any_of(tile - 1) & Flags(kLastRow)) | (any_of(tile + 1) & Flags(kFirstRow));
    tiles |= nonzero_lanes(any) << part;
  }
  return tiles;
}

/// Writes the numbers of a group's tiles to `list` and returns how many. May write kTileGroup
/// entries.
[[gnu::always_inline]] inline Index append_tiles(std::uint32_t* list, Index first,
                                                 std::uint32_t tiles) {
  if constexpr (kHasCompress) {
    static_assert(!kHasCompress || 2 * kRowLanes == kTileGroup);
    const Lanes32 low = lane_numbers() + Lanes32(static_cast<std::uint32_t>(first));
    store_compressed(list, low, tiles);
    store_compressed(list + __builtin_popcount(tiles & 0xFFFF), low + Lanes32(16), tiles >> 16);
  } else {
    for (std::uint32_t rest = tiles; rest != 0; rest &= rest - 1) {
      *list++ = static_cast<std::uint32_t>(first + __builtin_ctz(rest));
    }
  }
  return __builtin_popcount(tiles);
}

/// Bits [64 i + offset, 64 i + offset + 64) of a bit set of `words` words; bits outside are zero.
std::uint64_t bits_from(const std::uint64_t* bits, Index words, Index i, Index offset) {
  const Index from = i * kWordBits + offset;
  const Index word = from >> 6;
  const Index shift = from & 63;
  const auto at = [&](Index w) { return 0 <= w && w < words ? bits[w] : 0; };
  return shift == 0 ? at(word) : at(word) >> shift | at(word + 1) << (kWordBits - shift);
}

/// Occupied groups of word `i` with visited tiles in or next to them: only these can have active
/// tiles.
std::uint64_t candidates(const TileGridView& grid, const std::uint64_t* visited, Index i) {
  const Index strip = grid.strip_tiles / kTileGroup;  // rounded down
  const Index words = (grid.groups + kWordBits - 1) / kWordBits;
  std::uint64_t near = 0;
  for (const Index column : {-strip - 1, -strip, Index{0}, strip, strip + 1}) {
    for (const Index row : {-1, 0, 1}) near |= bits_from(visited, words, i, column + row);
  }
  return near & grid.occupied_groups[i];
}

/// The list must include every tile that changed, because only a visit resets a tile's flags: the
/// flags of tiles that are not listed must be zero.
Index list_active(const TileGridView& shared_grid, const TileListing& shared_listing) {
  const TileGridView grid = shared_grid;  // local copies, which stores cannot alias
  const TileListing listing = shared_listing;
  std::uint32_t* const latest = grid.changed_near[static_cast<std::size_t>(listing.sub_iteration)];
  const std::uint32_t* earlier[kMaxSubIterations];
  for (int k = 1; k < listing.sub_iterations; ++k) {
    const int sub = (listing.sub_iteration + k) % listing.sub_iterations;
    earlier[k] = grid.changed_near[static_cast<std::size_t>(sub)];
  }
  Index count = 0;
  for (Index i = listing.first_word; i < listing.last_word; ++i) {
    std::uint64_t visited = 0;
    for (std::uint64_t rest = candidates(grid, listing.visited, i); rest != 0; rest &= rest - 1) {
      const Index group = i * kWordBits + __builtin_ctzll(rest);
      std::uint32_t active = tiles_near_changes(grid, group * kTileGroup);
      latest[group] = active;
      for (int k = 1; k < listing.sub_iterations; ++k) active |= earlier[k][group];
      active &= grid.occupied[group];
      count += append_tiles(listing.list + count, group * kTileGroup, active);
      // Without a branch, which would be unpredictable.
      visited |= std::uint64_t{active != 0} << (group % kWordBits);
    }
    listing.next_visited[i] = visited;
  }
  return count;
}

/// Whether tiles[i + delay] - tiles[i] >= reach for all i.
bool is_sufficient(const std::uint32_t* tiles, Index count, std::uint32_t reach, Index delay) {
  constexpr Index chunk = 512;  // the inner loop has no exit, so that it is vectorised
  for (Index begin = 0; begin + delay < count; begin += chunk) {
    const Index end = std::min(begin + chunk, count - delay);
    std::uint32_t near = 0;
    for (Index i = begin; i < end; ++i) near |= tiles[i + delay] - tiles[i] < reach ? 1 : 0;
    if (near != 0) return false;
  }
  return true;
}

Index find_delay(const std::uint32_t* tiles, Index count, std::uint32_t reach, Index guess,
                 Index max_delay) {
  constexpr Index small = 64;  // 4 KB: a search would not pay
  if (max_delay <= small) return max_delay;
  Index delay = std::clamp(guess, small / 2, max_delay);
  while (delay < max_delay && !is_sufficient(tiles, count, reach, delay)) {
    delay = std::min(max_delay, delay + delay / 8 + 1);
  }
  for (Index less = delay - delay / 8 - 1; less >= small / 2; less = delay - delay / 8 - 1) {
    if (!is_sufficient(tiles, count, reach, less)) break;
    delay = less;
  }
  return delay;
}

template <class Visitor>
[[gnu::always_inline]] inline void visit_tiles(const Visitor& visitor, const TileGridView& grid,
                                               const TileRange& range) {
  if (grid.border_tiles == nullptr) {
    visit_tiles<false>(visitor, grid, range);
  } else {
    visit_tiles<true>(visitor, grid, range);
  }
}

template <class Rule, int sub>
void built_in_pass(const BoundScan&, const TileGridView& grid, const TileRange& range) {
  visit_tiles(BuiltInVisitor<Rule, sub>{}, grid, range);
}

void pass_by_scan(const BoundScan& scan, const TileGridView& grid, const TileRange& range) {
  visit_tiles(ScanVisitor{scan}, grid, range);
}

consteval BuiltInTilePasses make_passes() {
  BuiltInTilePasses passes{};
  for_each_parallel_rule([&]<class Type>(BuiltInRule rule) {
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      ((passes.by_rule[rule][subs] = &built_in_pass<Type, subs>), ...);
    }
    (std::make_integer_sequence<int, Type::kSubIterations>{});
  });
  passes.by_scan = &pass_by_scan;
  return passes;
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const TileKernels Exported<TileKernels, kThisIsa>::kKernels = {&list_active, &find_delay};

template <>
constinit const BuiltInTilePasses Exported<BuiltInTilePasses, kThisIsa>::kKernels = make_passes();

}  // namespace thinbench::detail
