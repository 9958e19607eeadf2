// Checks that the margin of a plane or of a tile grid is zero: engines read it and must not write
// it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/plane_view.hpp"
#include "engines/tile_grid.hpp"

namespace thinbench {

/// Reads everything that must be zero: kMarginRows rows above and below, the elements between the
/// end of a row and the start of the next, two elements before the first row, and the bits past the
/// width. Rows one block apart have no elements between them.
template <class T>
[[nodiscard]] bool margin_is_zero(const detail::ConstPlaneView<T>& plane) {
  constexpr Index pixels_of_element = sizeof(T) == 1 ? 1 : detail::kWordBits;
  const Index elements_beside = plane.stride > plane.row_elements ? 2 : 0;
  const auto all_zero = [](const T* first, const T* last) {
    return std::all_of(first, last, [](T element) { return element == 0; });
  };
  for (Index y = -detail::kMarginRows; y < plane.height + detail::kMarginRows; ++y) {
    const bool is_row = y >= 0 && y < plane.height;
    const Index pixels = is_row ? plane.width : 0;
    const T* row = plane.row(y);
    const Index full = pixels / pixels_of_element;
    const Index rest = pixels % pixels_of_element;
    if (rest != 0 && row[full] >> rest != 0) return false;
    const bool is_last = y + 1 == plane.height + detail::kMarginRows;
    const Index end = is_last ? plane.row_elements : plane.stride;
    if (!all_zero(row - elements_beside, row)) return false;
    if (!all_zero(row + full + (rest != 0 ? 1 : 0), row + end)) return false;
  }
  return true;
}

template <class T>
[[nodiscard]] bool margin_is_zero(const detail::PlaneView<T>& plane) {
  return margin_is_zero(detail::ConstPlaneView<T>(plane));
}

/// The same for the tiles around an image and for the pixels past its last column and row.
[[nodiscard]] inline bool margin_is_zero(const detail::TileGridView& grid) {
  const auto pixels_of = [&](Index tile, Index row) {
    const Index column = tile % grid.stride - 1;
    const Index y = tile / grid.stride * grid.shape.rows + row;
    if (column < 0 || y >= grid.height) return std::uint32_t{0};
    const Index columns =
        std::clamp<Index>(grid.width - column * detail::kTileColumns, 0, detail::kTileColumns);
    return static_cast<std::uint32_t>((std::uint64_t{1} << columns) - 1);
  };
  for (Index tile = 0; tile <= grid.tile_rows * grid.stride; ++tile) {
    for (Index row = 0; row < grid.shape.rows; ++row) {
      const std::uint32_t word = grid.words[tile * grid.shape.rows + grid.shape.word_of_row(row)];
      if ((word & ~pixels_of(tile, row)) != 0) return false;
    }
  }
  return true;
}

}  // namespace thinbench
