#include "engines/tile_grid.hpp"

#include <utility>

namespace thinbench::detail {
namespace {

std::size_t count_of(Index elements) {
  return static_cast<std::size_t>(elements);
}

Index tile_columns_of(Index width) {
  return (width + kTileColumns - 1) / kTileColumns;
}

Index tile_rows_of(Index height, const TileShape& shape) {
  return (height + shape.rows - 1) / shape.rows;
}

/// Equal parts of a block of zeros, each from the start of a cache line on. One block, as a thread
/// keeps few.
template <class T>
class Parts {
 public:
  Parts(AlignedArray<T>& block, Index count, Index elements)
      : size_(round_up(elements, static_cast<Index>(kAlignment / sizeof(T)))) {
    block = make_aligned<T>(count_of(count * size_));
    next_ = block.get();
  }

  T* take() { return std::exchange(next_, next_ + size_); }

 private:
  Index size_;
  T* next_;
};

}  // namespace

bool TileGrid::fits(Index width, Index height, const TileShape& shape) {
  constexpr Index max_tiles = Index{1} << 30;  // 31 bits number them and the rows around them
  return tile_rows_of(height, shape) + 2 <= max_tiles / (tile_columns_of(width) + 2);
}

TileGrid::TileGrid(Index width, Index height, Border border, const TileShape& shape)
    : columns_(tile_columns_of(width)), view_{} {
  view_.width = width;
  view_.height = height;
  view_.shape = shape;
  view_.tile_rows = tile_rows_of(height, shape);
  view_.stride = columns_ + 2;
  view_.row_words = (view_.stride + kWordBits - 1) / kWordBits;
  const Index tiles = view_.tile_rows * view_.stride + 1;
  words_ = make_aligned<std::uint32_t>(count_of(tiles * shape.rows));
  view_.words = words_.get();

  const Index margin = round_up(view_.stride + 1, kBlockWords * 2);
  Parts edge_rows(edges_, 8, tiles + 2 * margin);
  for (TileEdges& edges : view_.edges) {
    for (auto* rows : {&edges.top, &edges.bottom}) {
      for (std::uint32_t*& row : *rows) row = edge_rows.take() + margin;
    }
  }

  view_.neighbours = view_.edges;
  for (TileEdges& edges : view_.neighbours) {
    for (std::uint32_t*& row : edges.top) row += view_.stride;
    for (std::uint32_t*& row : edges.bottom) row -= view_.stride;
  }

  if (shape.lanes <= 8) {
    Parts bytes(changed_lanes_, 5, tiles + kWordBits);
    view_.changed_lanes = {bytes.take(), bytes.take(), bytes.take(), bytes.take(), bytes.take()};
  }

  first_tiles_ = make_aligned<std::uint32_t>(count_of(view_.tile_rows * view_.row_words));
  for (Index i = 0; i < view_.tile_rows * view_.row_words; ++i) {
    const Index tile = i / view_.row_words * view_.stride + i % view_.row_words * kWordBits;
    first_tiles_[count_of(i)] = static_cast<std::uint32_t>(tile);
  }
  view_.first_tiles = first_tiles_.get();

  // With a row of tiles before the first one and after the last one.
  Parts sets(sets_, kMaxSubIterations + 9, (view_.tile_rows + 2) * view_.row_words);
  const auto make_set = [&] { return sets.take() + view_.row_words; };
  view_.occupied = make_set();
  view_.active = make_set();
  for (std::uint64_t*& near : view_.near) near = make_set();
  for (TileChanges& changes : view_.changes) changes = {make_set(), make_set(), make_set()};
  if (border == Border::keep) mark_border_tiles(make_set());
}

void TileGrid::mark_border_tiles(std::uint64_t* border) {
  for (Index row = 0; row < view_.tile_rows; ++row) {
    const bool outer_row = row == 0 || row == view_.tile_rows - 1;
    for (Index column = 0; column < columns_; ++column) {
      if (!outer_row && column != 0 && column != columns_ - 1) continue;
      const Index bit = column + 1;
      border[view_.first_word(row) + bit / kWordBits] |= std::uint64_t{1} << (bit % kWordBits);
    }
  }
  view_.border = border;
}

}  // namespace thinbench::detail
