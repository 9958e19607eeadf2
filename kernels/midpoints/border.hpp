// The border of the midpoint scan.
#pragma once

#include <algorithm>

#include "core/plane_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

inline void copy_pixel(const std::uint8_t* from, std::uint8_t* to, Index x) {
  to[x] = from[x];
}

inline void copy_pixel(const std::uint64_t* from, std::uint64_t* to, Index x) {
  const std::uint64_t bit = std::uint64_t{1} << (x % kWordBits);
  std::uint64_t& word = to[x / kWordBits];
  word ^= (word ^ from[x / kWordBits]) & bit;
}

/// With Border::keep, copies the outermost rows and columns.
template <class T>
void apply_border(Border border, const ConstPlaneView<T>& source, const PlaneView<T>& target) {
  if (border == Border::background || source.width == 0) return;
  for (Index y = 0; y < source.height; ++y) {
    if (y == 0 || y == source.height - 1) {
      std::copy_n(source.row(y), source.row_elements, target.row(y));
    }
    copy_pixel(source.row(y), target.row(y), 0);
    copy_pixel(source.row(y), target.row(y), source.width - 1);
  }
}

}  // namespace thinbench::detail
