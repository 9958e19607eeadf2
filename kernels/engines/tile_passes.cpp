// Sub-iterations on tiles of packed pixels. Visits only tiles in which, or within one pixel
// of which, something changed since the same sub-iteration last ran. Compiled per ISA.
//
// Cost per tile at AVX-512: 12 loads, 6 of them of single words, 6 permutations, 8 funnel shifts,
// twice the rule's gates, 2 gates and 7 mask instructions for what changed, 2 stores of pixels and
// 1 of changes. With Guo-Hall that is 28 to 32 cycles where tiles are in the third-level cache.
//
// The grid is updated in place: the new pixels of a tile are stored one visit later, when the tile
// to the east has read the old ones. The tiles above and below read only edges, of which there are
// two copies.
//
// What was tried: docs/experiments.md#tiles.
#include "engines/tile_passes.hpp"

#include <algorithm>
#include <utility>

#include "core/exported.hpp"
#include "engines/tile_registers.hpp"
#include "scan/built_in.hpp"
#include "scan/window.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

using RowLanes = Lanes32;  // one row of a tile per lane
static_assert(kTileRegisters == kScannedRegisters || kTileLanes == 4);  // then there are no scans

/// `body.template operator()<k>()` for all registers of a tile, unrolled.
template <class Body>
[[gnu::always_inline]] inline void for_registers(const Body& body) {
  [&]<Index... numbers>(std::integer_sequence<Index, numbers...>) __attribute__((always_inline)) {
    (body(std::integral_constant<Index, numbers>{}), ...);
  }
  (std::make_integer_sequence<Index, kTileRegisters>{});
}

/// A tile in registers.
struct Tile {
  RowLanes rows[kTileRegisters];
};

/// Row access for rules: row(y) is register y of a tile; the registers above the first and below
/// the last take the rows that are not the tile's from edges.
struct RowsOfTile {
  const std::uint32_t* words;
  const std::uint32_t* above[2];  // the last row of the tile above, and the one above that
  const std::uint32_t* below[2];

  /// `edges` are by the tile that reads them.
  [[gnu::always_inline]] RowsOfTile(const TileEdges& edges, const std::uint32_t* grid_words,
                                    Index tile)
      : words(grid_words + tile * kTileRows),
        above{edges.bottom[0] + tile, edges.bottom[1] + tile},
        below{edges.top[0] + tile, edges.top[1] + tile} {}

  /// Register `y` of the tile, or of the one `column` tiles to the east.
  [[gnu::always_inline]] RowLanes load(Index column, Index y) const {
    const auto own = [&](Index number) { return words + column * kTileRows + number * kTileLanes; };
    if (y < 0) return previous_lanes(own(y + kTileRegisters), above[-1 - y][column]);
    if (y >= kTileRegisters)
      return next_lanes(own(y - kTileRegisters), below[y - kTileRegisters][column]);
    return RowLanes::load_aligned(own(y));
  }

  [[gnu::always_inline]] RowTriple<RowLanes> row(Index y) const {
    const RowLanes centre = load(0, y);
    return {west_neighbour<1>(centre, load(-1, y)), centre, east_neighbour<1>(centre, load(1, y))};
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<RowLanes> features(Index y, const RowTriple<RowLanes>& above_y,
                                                      const RowTriple<RowLanes>& here,
                                                      const RowTriple<RowLanes>& below_y) const {
    return feature_triple<Rule>(above_y, here, below_y, west_neighbour<2>(here.centre, load(-1, y)),
                                east_neighbour<2>(here.centre, load(1, y)));
  }
};

/// Visitors compute a tile's new pixels.
template <class Rule, int sub>
struct BuiltInVisitor {
  [[gnu::always_inline]] void operator()(const RowsOfTile& rows, Tile& next) const {
    Window<Rule, RowsOfTile> window(rows, 0);
    for_registers([&](auto y) __attribute__((always_inline)) {
      next.rows[y] = window.template next<sub>(Rule{}, rows, y);
      window.move_down();
    });
  }
};

/// The same by a scan function.
struct ScanVisitor {
  const BoundScan& scan;

  [[gnu::always_inline]] void operator()(const RowsOfTile& rows, Tile& next) const {
    alignas(sizeof(RowLanes)) std::uint32_t target[kTileRegisters][kTileLanes];
    scan({.source = rows.words,
          .source_stride = 0,
          .target = target,
          .target_stride = 0,
          .rows = 0,
          .band_rows = 0,
          .fixed = nullptr,
          .above = rows.above[0],
          .below = rows.below[0]});
    for_registers([&](auto y) { next.rows[y] = RowLanes::load_aligned(target[y]); });
  }
};

/// Stores what changed in a tile. In registers of 16 lanes, in an entry of four numbers of 16 bits,
/// from the low end:
/// - the changed rows of the first register: bit 0 is the first row of the tile
/// - those of the last: bit 15 is the last row of the tile
/// - the lanes with changes in the first column: bit 0 tells of the first row, and possibly of
///   others, bit 15 of the last row
/// - the same of the last column
/// Else in ChangedLanes.
[[gnu::always_inline]] inline void store_changes(const TileGridView& grid, std::uint64_t* entry,
                                                 Index tile, const Tile& next) {
  const std::uint32_t* const words = grid.words + tile * kTileRows;
  Tile changed;
  for_registers([&](auto y) {
    changed.rows[y] = RowLanes::load_aligned(words + y * kTileLanes) ^ next.rows[y];
  });
  RowLanes any = changed.rows[0];
  for_registers([&](auto y) { any = any | changed.rows[y]; });
  const RowLanes& first = changed.rows[0];
  const RowLanes& last = changed.rows[kTileRegisters - 1];
  if constexpr (kRegisterHoldsRow) {
    store_lane_bits(entry, first, last, any);
  } else {
    const ChangedLanes& lanes = grid.changed_lanes;
    if (kTileRegisters > 2) lanes.any[tile] = static_cast<std::uint8_t>(nonzero_lanes(any));
    lanes.west[tile] = static_cast<std::uint8_t>(lowest_bits(any));
    lanes.east[tile] = static_cast<std::uint8_t>(highest_bits(any));
    lanes.first[tile] = static_cast<std::uint8_t>(nonzero_lanes(first));
    lanes.last[tile] = static_cast<std::uint8_t>(nonzero_lanes(last));
  }
}

/// The border pixels of the image within a tile.
struct BorderOfTile {
  std::uint32_t columns;  // bit set of columns
  std::uint32_t rows;     // bit set of rows
};

inline BorderOfTile border_of(const TileGridView& grid, Index tile) {
  const Index x = (tile % grid.stride - 1) * kTileColumns;
  const Index y = tile / grid.stride * kTileRows;
  const auto bit = [](Index at, Index size) {
    return 0 <= at && at < size ? std::uint32_t{1} << at : 0;
  };
  return {bit(-x, kTileColumns) | bit(grid.width - 1 - x, kTileColumns),
          bit(-y, kTileRows) | bit(grid.height - 1 - y, kTileRows)};
}

/// Restores the border pixels of a tile. `words` are its new pixels.
[[gnu::noinline]] void restore_border(const TileGridView& grid, Index tile, std::uint32_t* words) {
  const BorderOfTile border = border_of(grid, tile);
  for (Index y = 0; y < kTileRows; ++y) {
    const std::uint32_t fixed = (border.rows >> y & 1) != 0 ? ~std::uint32_t{0} : border.columns;
    const Index word = kTileShape.word_of_row(y);
    words[word] |= grid.words[tile * kTileRows + word] & fixed;
  }
}

/// Writes new pixels to the grid.
template <std::size_t depth>
[[gnu::always_inline]] inline void commit(const TileGridView& grid, const TileEdges& edges,
                                          Index tile, const Tile& next) {
  std::uint32_t* const words = grid.words + tile * kTileRows;
  for_registers([&](auto y) { next.rows[y].store_aligned(words + y * kTileLanes); });
  for (std::size_t i = 0; i < depth; ++i) {
    const auto y = static_cast<Index>(i);
    edges.top[i][tile] = words[kTileShape.word_of_row(y)];
    edges.bottom[i][tile] = words[kTileShape.word_of_row(kTileRows - 1 - y)];
  }
}

/// Computes the new pixels of a tile.
template <bool has_border, class Visitor>
[[gnu::always_inline]] inline void visit_tile(const Visitor& visitor, const TileGridView& grid,
                                              const TileEdges& edges, std::uint32_t number,
                                              Tile& next) {
  const Index tile = has_border ? number & ~kBorderTile : number;
  visitor(RowsOfTile(edges, grid.words, tile), next);
  if (has_border && (number & kBorderTile) != 0) {
    alignas(sizeof(RowLanes)) std::uint32_t words[kTileRows];
    for_registers([&](auto y) { next.rows[y].store_aligned(words + y * kTileLanes); });
    restore_border(grid, tile, words);
    for_registers([&](auto y) { next.rows[y] = RowLanes::load_aligned(words + y * kTileLanes); });
  }
}

/// Prefetches memory, a part after each group of tiles. A branch per tile would cost a sixth of the
/// time, as it takes registers: docs/experiments.md#tiles.
class GroupPrefetcher {
 public:
  GroupPrefetcher(const ConstBytes& memory, Index tiles)
      : rest_(memory),
        group_(memory.size == 0 ? tiles : kGroup),
        part_(round_up(memory.size * group_ / tiles + 1, kLine)) {}

  [[nodiscard]] Index group() const { return group_; }

  [[gnu::always_inline]] void prefetch_part() {
    const Index size = std::min(part_, rest_.size);
    for (Index i = 0; i < size; i += kLine) __builtin_prefetch(rest_.data + i, 0, 2);
    rest_.data += size;
    rest_.size -= size;
  }

 private:
  static constexpr Index kGroup = 4;
  static constexpr Index kLine = 64;

  ConstBytes rest_;
  Index group_;
  Index part_;
};

/// `depth`: how many rows of the tiles above and below the rule reads.
template <std::size_t depth, bool has_border, class Visitor>
[[gnu::always_inline]] inline void visit_tiles(const Visitor& visitor, const TileGridView& shared,
                                               const TileList& shared_list) {
  const TileGridView grid = shared;  // local copies, which stores cannot alias
  const TileList list = shared_list;
  const TileEdges from = grid.neighbours[list.parity];
  const TileEdges to = grid.edges[1 - list.parity];
  GroupPrefetcher prefetcher(list.ahead, list.count);
  Index pending_tile = list.tiles[0] & ~kBorderTile;
  Tile pending;  // at first the old pixels, so that the loop needs no condition
  for_registers([&](auto y) {
    pending.rows[y] =
        RowLanes::load_aligned(grid.words + pending_tile * kTileRows + y * kTileLanes);
  });
  std::uint64_t* changes = list.changes;
  const std::uint32_t* const last = list.tiles + list.count;
  for (const std::uint32_t* tile = list.tiles; tile < last;) {
    const std::uint32_t* const end = tile + std::min<Index>(prefetcher.group(), last - tile);
    for (; tile < end; ++tile, ++changes) {
      const std::uint32_t number = *tile;
      const Index current = has_border ? number & ~kBorderTile : number;
      Tile next;
      visit_tile<has_border>(visitor, grid, from, number, next);
      store_changes(grid, changes, current, next);
      commit<depth>(grid, to, pending_tile, pending);
      pending = next;
      pending_tile = current;
    }
    prefetcher.prefetch_part();
  }
  commit<depth>(grid, to, pending_tile, pending);
}

template <std::size_t depth, class Visitor>
[[gnu::always_inline]] inline void visit_tiles(const Visitor& visitor, const TileGridView& grid,
                                               const TileList& list) {
  if (grid.border == nullptr) {
    visit_tiles<depth, false>(visitor, grid, list);
  } else {
    visit_tiles<depth, true>(visitor, grid, list);
  }
}

template <class Rule, int sub>
void built_in_pass(const BoundScan&, const TileGridView& grid, const TileList& list) {
  visit_tiles<TwoStageRule<Rule> ? 2 : 1>(BuiltInVisitor<Rule, sub>{}, grid, list);
}

void pass_by_scan(const BoundScan& scan, const TileGridView& grid, const TileList& list) {
  visit_tiles<1>(ScanVisitor{scan}, grid, list);
}

/// Activates the tiles of a word of bits, or of a batch of them.
template <class Word>
[[gnu::always_inline]] inline void activate(const TileGridView& grid,
                                            const TileActivation& activation, Index at) {
  using Traits = WordTraits<Word>;
  const TileChanges& last = grid.changes[1 - activation.parity];
  const TileChanges& next = grid.changes[activation.parity];
  const std::size_t subs = activation.sub_iterations;
  Word active = Traits::load(last.here + at) | Traits::load(last.below + at + grid.row_words) |
                Traits::load(last.above + at - grid.row_words);
  Traits::store(grid.near[(activation.sub_iteration + subs - 1) % subs] + at, active);
  for (std::size_t k = 0; k + 1 < subs; ++k) {
    active = active | Traits::load(grid.near[(activation.sub_iteration + k) % subs] + at);
  }
  Traits::store(grid.active + at, active & Traits::load(grid.occupied + at));
  for (std::uint64_t* set : {next.here, next.below, next.above}) {
    Traits::store(set + at, Traits::zero());
  }
}

ActiveCount find_active(const TileGridView& shared_grid, const TileActivation& shared_activation) {
  const TileGridView grid = shared_grid;  // local copies, which stores cannot alias
  const TileActivation activation = shared_activation;
  constexpr auto step = static_cast<Index>(WordBatch::size);
  const Index end = grid.first_word(activation.last_row);
  Index at = grid.first_word(activation.first_row);
  ActiveCount found{};
  const auto append = [&](Index word) {
    activation.words[found.words] = static_cast<std::uint32_t>(word);
    found.words += grid.active[word] != 0 ? 1 : 0;  // without a branch
  };
  if constexpr (kHasCompress) {
    const Lanes32 numbers = lane_numbers();
    for (; at + step <= end; at += step) {
      activate<WordBatch>(grid, activation, at);
      const std::uint32_t nonzero = nonzero_lanes(WordBatch::load_unaligned(grid.active + at));
      store_compressed(activation.words + found.words,
                       numbers + Lanes32(static_cast<std::uint32_t>(at)), nonzero);
      found.words += __builtin_popcount(nonzero);
    }
  } else {
    for (; at + step <= end; at += step) {
      activate<WordBatch>(grid, activation, at);
      for (Index word = at; word < at + step; ++word) append(word);
    }
  }
  for (; at < end; ++at) {
    activate<std::uint64_t>(grid, activation, at);
    append(at);
  }
  for (Index i = 0; i < found.words; ++i) {
    activation.before[i] = static_cast<std::uint32_t>(found.tiles);
    found.tiles += __builtin_popcountll(grid.active[activation.words[i]]);
  }
  return found;
}

/// Writes the numbers of tiles, from `first` on, to `list`. May write whole registers.
[[gnu::always_inline]] inline void append_tiles(std::uint32_t* list, std::uint32_t first,
                                                std::uint64_t tiles) {
  if constexpr (kHasCompress) {
    Lanes32 numbers = lane_numbers() + Lanes32(first);
    for (; tiles != 0; tiles >>= kTileLanes) {
      const auto selected = static_cast<std::uint32_t>(tiles & ((1U << kTileLanes) - 1));
      store_compressed(list, numbers, selected);
      list += __builtin_popcount(selected);
      numbers = numbers + Lanes32(static_cast<std::uint32_t>(kTileLanes));
    }
  } else {
    for (std::uint64_t rest = tiles; rest != 0; rest &= rest - 1) {
      *list++ = first + static_cast<std::uint32_t>(__builtin_ctzll(rest));
    }
  }
}

/// Marks the border tiles among those of a word, which are in `list`.
void mark_border_tiles(std::uint32_t* list, std::uint64_t tiles, std::uint64_t border) {
  for (std::uint64_t rest = tiles & border; rest != 0; rest &= rest - 1) {
    list[__builtin_popcountll(tiles & ((rest & -rest) - 1))] |= kBorderTile;
  }
}

ActiveCount list_tiles(const TileGridView& shared, const TileWords& words, std::uint32_t* tiles) {
  const TileGridView grid = shared;
  ActiveCount listed{};
  for (; listed.words < words.count; ++listed.words) {
    const Index word = words.words[listed.words];
    const std::uint64_t active = grid.active[word];
    if (listed.tiles >= kMinChunk) {
      // The last tile of a row of tiles is background, so the word before is in the same row.
      const bool adjacent = (grid.active[word - 1] >> (kWordBits - 1) & active & 1) != 0;
      if (!adjacent) break;
    }
    append_tiles(tiles + listed.tiles, grid.first_tiles[word], active);
    if (grid.border != nullptr) {
      mark_border_tiles(tiles + listed.tiles, active, grid.border[word]);
    }
    listed.tiles += __builtin_popcountll(active);
  }
  return listed;
}

/// What changed in the tiles of a word, a bit per tile.
struct ChangedTiles {
  std::uint64_t any, top, bottom, west, east, north_west, north_east, south_west, south_east;
};

template <class Body>
[[gnu::always_inline]] inline void for_all_bits(const Body& body) {
  using Tiles = ChangedTiles;
  for (const auto bits :
       {&Tiles::any, &Tiles::top, &Tiles::bottom, &Tiles::west, &Tiles::east, &Tiles::north_west,
        &Tiles::north_east, &Tiles::south_west, &Tiles::south_east}) {
    body(bits);
  }
}

/// Bit i is of entry i. A template because not every ISA has the vectors.
template <class Entry>
[[gnu::always_inline]] inline ChangedTiles changed_entries(const Entry* changes) {
  const auto [first, last, west, east] = quarters_of_words(changes);
  const Lanes16 lowest(std::uint16_t{1});
  const Lanes16 highest(std::uint16_t{0x8000});
  return {nonzero_lanes(first | last),
          nonzero_lanes(first & lowest),
          nonzero_lanes(last & highest),
          nonzero_lanes(west),
          nonzero_lanes(east),
          nonzero_lanes(first & west & lowest),
          nonzero_lanes(first & east & lowest),
          nonzero_lanes(last & west & highest),
          nonzero_lanes(last & east & highest)};
}

/// What changed in any register, from `tile` on, visited or not, for as many tiles as a batch has
/// bytes. At the end of a row they include tiles of the next one, which another thread may be
/// writing: callers mask them out. This and changed_lanes() are templates because not every ISA
/// uses them.
template <class Lanes>
[[gnu::always_inline]] inline ByteBatch any_lanes(const Lanes& lanes, Index tile) {
  if (kTileRegisters > 2) return ByteBatch::load_unaligned(lanes.any + tile);
  return ByteBatch::load_unaligned(lanes.first + tile) |
         ByteBatch::load_unaligned(lanes.last + tile);
}

/// Of the same tiles.
template <class Lanes>
[[gnu::always_inline]] inline ChangedTiles changed_lanes(const Lanes& lanes, Index tile) {
  const auto load = [&](const std::uint8_t* from) {
    return ByteBatch::load_unaligned(from + tile);
  };
  const ByteBatch lowest(std::uint8_t{1});
  const ByteBatch highest(static_cast<std::uint8_t>(1U << (kTileLanes - 1)));
  const ByteBatch west = load(lanes.west);
  const ByteBatch east = load(lanes.east);
  const ByteBatch top = load(lanes.first) & lowest;
  const ByteBatch bottom = load(lanes.last) & highest;
  return {nonzero_bits(any_lanes(lanes, tile)),
          nonzero_bits(top),
          nonzero_bits(bottom),
          nonzero_bits(west),
          nonzero_bits(east),
          nonzero_bits(top & west),
          nonzero_bits(top & east),
          nonzero_bits(bottom & west),
          nonzero_bits(bottom & east)};
}

/// Of the tiles of a word. `changes` has their entries.
[[gnu::always_inline]] inline ChangedTiles changed_tiles(const TileGridView& grid, Index word,
                                                         const std::uint64_t* changes) {
  const std::uint64_t tiles = grid.active[word];
  ChangedTiles changed{};
  if constexpr (kRegisterHoldsRow) {
    constexpr int entries = 32;
    changed = changed_entries(changes);
    if (__builtin_popcountll(tiles) > entries) {
      const ChangedTiles more = changed_entries(changes + entries);
      for_all_bits([&](auto bits) { changed.*bits |= more.*bits << entries; });
    }
    for_all_bits([&](auto bits) { changed.*bits = scatter_bits(changed.*bits, tiles); });
  } else {
    constexpr auto step = static_cast<Index>(ByteBatch::size);
    for (Index at = 0; at < kWordBits; at += step) {
      const Index tile = grid.first_tiles[word] + at;
      if ((tiles >> at & ~std::uint64_t{0} >> (kWordBits - step)) == 0) continue;
      const auto any = nonzero_bits(any_lanes(grid.changed_lanes, tile));
      if ((tiles >> at & any) == 0) continue;
      const ChangedTiles some = changed_lanes(grid.changed_lanes, tile);
      for_all_bits([&](auto bits) { changed.*bits |= some.*bits << at; });
    }
    for_all_bits([&](auto bits) { changed.*bits &= tiles; });
  }
  return changed;
}

/// Correct for two-stage rules too, see TwoStageRule.
void record_changes(const TileGridView& shared, const TileWords& words,
                    const std::uint64_t* changes, std::size_t parity) {
  const TileGridView grid = shared;
  const TileChanges sets = grid.changes[parity];
  for (Index i = 0; i < words.count; ++i) {
    const Index word = words.words[i];
    const ChangedTiles changed = changed_tiles(grid, word, changes);
    changes += __builtin_popcountll(grid.active[word]);
    sets.here[word] |= changed.any | changed.west >> 1 | changed.east << 1;
    sets.below[word] |= changed.top | changed.north_west >> 1 | changed.north_east << 1;
    sets.above[word] |= changed.bottom | changed.south_west >> 1 | changed.south_east << 1;
    constexpr int last = static_cast<int>(kWordBits - 1);
    if ((changed.west & 1) != 0) {  // never in the first word of a row
      sets.here[word - 1] |= changed.west << last;
      sets.below[word - 1] |= changed.north_west << last;
      sets.above[word - 1] |= changed.south_west << last;
    }
    if (changed.east >> last != 0) {
      sets.here[word + 1] |= changed.east >> last;
      sets.below[word + 1] |= changed.north_east >> last;
      sets.above[word + 1] |= changed.south_east >> last;
    }
  }
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
constinit const TileKernels Exported<TileKernels, kThisIsa>::kKernels = {&find_active, &list_tiles,
                                                                         &record_changes};

template <>
constinit const BuiltInTilePasses Exported<BuiltInTilePasses, kThisIsa>::kKernels = make_passes();

}  // namespace thinbench::detail
