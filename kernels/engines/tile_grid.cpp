#include "engines/tile_grid.hpp"

#include <algorithm>

namespace thinbench::detail {
namespace {

std::size_t count_of(Index elements) {
  return static_cast<std::size_t>(elements);
}

Index strips_of(Index width) {
  return (width + kTileColumns - 1) / kTileColumns;
}

Index tile_rows_of(Index height) {
  return (height + kTileRows - 1) / kTileRows;
}

/// Odd, so that horizontally adjacent tiles never map to the same cache set.
Index strip_tiles_of(Index tile_rows) {
  return (tile_rows + 1) | 1;
}

}  // namespace

bool TileGrid::fits(Index width, Index height) {
  constexpr Index max_tiles = Index{1} << 31;  // half of them, as sums with a strip must fit, too
  return strips_of(width) + 2 <= max_tiles / strip_tiles_of(tile_rows_of(height));
}

TileGrid::TileGrid(Index width, Index height, Border border)
    : strips_(strips_of(width)), tile_rows_(tile_rows_of(height)), view_{} {
  view_.width = width;
  view_.height = height;
  view_.strip_tiles = strip_tiles_of(tile_rows_);
  const Index tiles = round_up((strips_ + 2) * view_.strip_tiles, kTileGroup);
  view_.groups = tiles / kTileGroup;
  words_ = make_aligned<std::uint32_t>(count_of((tiles + 2) * kTileRows));
  view_.words = words_.get() + kTileRows;

  const Index margin = round_up(view_.strip_tiles + kTileGroup, kTileGroup);
  const std::array flags = {&view_.changed_rows, &view_.changed_west, &view_.changed_east};
  for (std::size_t i = 0; i < flags.size(); ++i) {
    changed_[i] = make_aligned<std::uint16_t>(count_of(tiles + 2 * margin));
    *flags[i] = changed_[i].get() + margin;
  }
  occupied_ = make_aligned<std::uint32_t>(count_of(view_.groups));
  view_.occupied = occupied_.get();
  changed_near_ = make_aligned<std::uint32_t>(count_of(kMaxSubIterations * view_.groups));
  for (Index sub = 0; sub < kMaxSubIterations; ++sub) {
    view_.changed_near[count_of(sub)] = changed_near_.get() + sub * view_.groups;
  }
  occupied_groups_ = make_aligned<std::uint64_t>(count_of(group_words()));
  view_.occupied_groups = occupied_groups_.get();
  if (border == Border::keep) mark_border_tiles();
}

void TileGrid::mark_border_tiles() {
  border_tiles_ = make_aligned<std::uint32_t>(count_of(view_.groups));
  view_.border_tiles = border_tiles_.get();
  const auto mark = [&](Index strip, Index row) {
    const Index tile = (strip + 1) * view_.strip_tiles + row;
    border_tiles_[count_of(tile / kTileGroup)] |= std::uint32_t{1} << (tile % kTileGroup);
  };
  for (Index strip = 0; strip < strips_; ++strip) {
    for (Index row = 0; row < tile_rows_; ++row) {
      const bool outer_strip = strip == 0 || strip == strips_ - 1;
      if (outer_strip || row == 0 || row == tile_rows_ - 1) mark(strip, row);
    }
  }
}

void TileGrid::find_occupied() {
  for (Index group = 0; group < view_.groups; ++group) {
    std::uint32_t tiles = 0;
    for (Index i = 0; i < kTileGroup; ++i) {
      const bool occupied = view_.changed_rows[group * kTileGroup + i] != 0;
      tiles |= std::uint32_t{occupied} << i;
    }
    occupied_[count_of(group)] = tiles;
  }
}

Index TileGrid::list_occupied(std::uint32_t* list) {
  std::fill_n(occupied_groups_.get(), group_words(), 0);
  Index count = 0;
  for (Index group = 0; group < view_.groups; ++group) {
    const std::uint32_t tiles = view_.occupied[group];
    for (std::uint32_t rest = tiles; rest != 0; rest &= rest - 1) {
      list[count++] = static_cast<std::uint32_t>(group * kTileGroup + __builtin_ctz(rest));
    }
    if (tiles == 0) continue;
    occupied_groups_[count_of(group / kWordBits)] |= std::uint64_t{1} << (group % kWordBits);
  }
  return count;
}

Index TileGrid::restart(std::uint32_t* list, std::uint64_t* visited) {
  const Index tiles = view_.groups * kTileGroup;
  find_occupied();
  for (std::uint16_t* flags : {view_.changed_rows, view_.changed_west, view_.changed_east}) {
    std::fill_n(flags, tiles, 0);
  }
  for (std::uint32_t* near : view_.changed_near) std::copy_n(view_.occupied, view_.groups, near);
  const Index count = list_occupied(list);
  std::copy_n(view_.occupied_groups, group_words(), visited);
  return count;
}

}  // namespace thinbench::detail
