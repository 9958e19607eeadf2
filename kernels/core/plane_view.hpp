// Views of planes, the two pixel formats that kernels work on: plain structs without ownership.
#pragma once

#include <cstdint>
#include <type_traits>

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

inline constexpr Index kWordBits = 64;
/// Rows of packed bits are padded to whole 512-bit blocks, so that every vector length fits.
inline constexpr Index kBlockWords = 8;

/// The maximum reach of a rule.
inline constexpr Index kMarginRows = 2;

/// A rectangle of elements with a margin of zeros, which kernels may read but never write:
/// kMarginRows rows above and below, and at least two elements before and after each row.
///
/// For T = std::uint8_t a row holds `width` pixels, one byte each, 0 or 1.
/// For T = std::uint64_t pixel x is bit x % 64 of word x / 64, low bit first. Bits past the width
/// are 0, so equality is a comparison of memory and area a sum of popcounts. In both, rows are
/// padded with zeros to `row_elements`, a multiple of 64 bytes. Kernels may compute on the padding,
/// where every thinning rule yields 0 again.
template <class T>
struct PlaneView {
  T* data = nullptr;  // pixel (0, 0)
  Index width = 0;
  Index height = 0;
  Index stride = 0;  // in elements
  Index row_elements = 0;

  [[nodiscard]] T* row(Index y) const { return data + y * stride; }
  operator PlaneView<const T>() const requires(!std::is_const_v<T>) {
    return {data, width, height, stride, row_elements};
  }
};

template <class T>
using ConstPlaneView = PlaneView<const T>;

using ConstBitPlaneView = ConstPlaneView<std::uint64_t>;
using BitPlaneView = PlaneView<std::uint64_t>;

/// Rows [first, last) of a view.
template <class View>
[[nodiscard]] View rows_of_view(View view, Index first, Index last) {
  view.data = view.row(first);
  view.height = last - first;
  return view;
}

}  // namespace thinbench::detail
