#include "thinning/tile_grid.hpp"

#include <algorithm>

namespace thinbench {
namespace {

constexpr Index kWordsOf64 = 2;  // strips that one 64-bit word of a plane holds

/// 32 pixels of a row, of the strip's columns.
std::uint32_t strip_word(const std::uint64_t* row, Index strip) {
  return static_cast<std::uint32_t>(row[strip / kWordsOf64] >> (strip % kWordsOf64 * kTileColumns));
}

std::size_t count_of(Index elements) {
  return static_cast<std::size_t>(elements);
}

}  // namespace

TileGrid::TileGrid(Index width, Index height)
    : strips_((width + kTileColumns - 1) / kTileColumns),
      tile_rows_((height + kTileRows - 1) / kTileRows),
      view_{} {
  // Odd, so that tiles of neighbouring strips never compete for one cache set.
  view_.strip_tiles = (tile_rows_ + 1) | 1;
  const Index tiles = round_up((strips_ + 2) * view_.strip_tiles, kTileGroup);
  view_.groups = tiles / kTileGroup;
  words_ = make_aligned<std::uint32_t>(count_of((tiles + 2) * kTileRows));
  view_.words = words_.get() + kTileRows;

  const Index margin = view_.strip_tiles + kTileGroup;
  const std::array flags = {&view_.changed_rows, &view_.changed_west, &view_.changed_east};
  for (std::size_t i = 0; i < flags.size(); ++i) {
    changed_[i] = make_aligned<std::uint16_t>(count_of(tiles + 2 * margin));
    *flags[i] = changed_[i].get() + margin;
  }
  occupied_ = make_aligned<std::uint32_t>(count_of(view_.groups));
  view_.occupied = occupied_.get();
  wanted_ = make_aligned<std::uint32_t>(count_of(TileGridView::kLongestCycle * view_.groups));
  for (Index step = 0; step < TileGridView::kLongestCycle; ++step) {
    view_.wanted[count_of(step)] = wanted_.get() + step * view_.groups;
  }
  const Index group_words = (view_.groups + kWordBits - 1) / kWordBits;
  groups_ = make_aligned<std::uint64_t>(count_of(3 * group_words));
  view_.occupied_groups = groups_.get();
  view_.visited = groups_.get() + group_words;
  view_.candidates = groups_.get() + 2 * group_words;
  // A whole group may be written behind the last entry.
  active_ = make_aligned<std::uint32_t>(count_of(strips_ * tile_rows_ + kTileGroup));
  view_.active = active_.get();
}

/// Leaves in `changed_rows` whether the tile has dark pixels.
void TileGrid::load_tile(const ConstBitPlaneView& plane, Index strip, Index row) {
  const Index tile = tile_at(strip, row);
  std::uint32_t* to = view_.words + tile * kTileRows;
  const Index rows = std::min(kTileRows, plane.height - row * kTileRows);
  std::uint32_t any = 0;
  for (Index y = 0; y < rows; ++y) {
    to[y] = strip_word(plane.row(row * kTileRows + y), strip);
    any |= to[y];
  }
  view_.changed_rows[tile] = any != 0 ? 1 : 0;
}

void TileGrid::find_occupied() {
  for (Index group = 0; group < view_.groups; ++group) {
    std::uint32_t tiles = 0;
    for (Index i = 0; i < kTileGroup; ++i) {
      tiles |= std::uint32_t{view_.changed_rows[group * kTileGroup + i]} << i;
    }
    occupied_[count_of(group)] = tiles;
  }
}

Index TileGrid::list_occupied() {
  const Index group_words = (view_.groups + kWordBits - 1) / kWordBits;
  std::fill_n(groups_.get(), group_words, 0);
  Index count = 0;
  for (Index group = 0; group < view_.groups; ++group) {
    const std::uint32_t tiles = view_.occupied[group];
    for (std::uint32_t left = tiles; left != 0; left &= left - 1) {
      view_.active[count++] = static_cast<std::uint32_t>(group * kTileGroup + __builtin_ctz(left));
    }
    if (tiles == 0) continue;
    groups_[count_of(group / kWordBits)] |= std::uint64_t{1} << (group % kWordBits);
  }
  std::copy_n(view_.occupied_groups, group_words, view_.visited);
  return count;
}

Index TileGrid::load(const ConstBitPlaneView& plane, const ThreadTeam& team) {
  const Index tiles = view_.groups * kTileGroup;
  std::fill_n(view_.changed_rows, tiles, 0);
  team.for_ranges(tile_rows_, [&](Index first, Index last) {
    for (Index row = first; row < last; ++row) {
      for (Index strip = 0; strip < strips_; ++strip) load_tile(plane, strip, row);
    }
  });
  find_occupied();
  for (std::uint16_t* flags : {view_.changed_rows, view_.changed_west, view_.changed_east}) {
    std::fill_n(flags, tiles, 0);
  }
  for (std::uint32_t* wanted : view_.wanted) std::copy_n(view_.occupied, view_.groups, wanted);
  return list_occupied();
}

void TileGrid::store(const BitPlaneView& plane, const ThreadTeam& team) const {
  const Index next_strip = view_.strip_tiles * kTileRows;
  team.for_ranges(plane.height, [&](Index first, Index last) {
    for (Index y = first; y < last; ++y) {
      const std::uint32_t* from =
          view_.words + tile_at(0, y / kTileRows) * kTileRows + y % kTileRows;
      for (Index strip = 0; strip < strips_; strip += kWordsOf64) {
        // The strip behind the last is light.
        const std::uint64_t low = from[strip * next_strip];
        const std::uint64_t high = from[(strip + 1) * next_strip];
        plane.row(y)[strip / kWordsOf64] = low | high << kTileColumns;
      }
    }
  });
}

}  // namespace thinbench
