// Memory of planes.
#pragma once

#include <cstdint>

#include "core/layout.hpp"
#include "core/plane_view.hpp"

namespace thinbench::detail {

/// Owns a plane. Rows start on cache lines; margin and padding are zero.
template <class T>
class Plane {
 public:
  Plane() = default;
  Plane(Index width, Index height) {
    constexpr Index element_bytes = static_cast<Index>(sizeof(T));
    constexpr Index block = static_cast<Index>(kAlignment) / element_bytes;
    constexpr Index pixels_per_element = sizeof(T) == 1 ? 1 : kWordBits;
    const Index row_elements = round_up(width, block * pixels_per_element) / pixels_per_element;
    // One block between rows serves as the margin after one row and before the next.
    const Index stride = padded_row_bytes((row_elements + block) * element_bytes) / element_bytes;
    const Index storage = block + (height + 2 * kMarginRows) * stride;
    data_ = make_aligned<T>(static_cast<std::size_t>(storage));
    view_ = {data_.get() + block + kMarginRows * stride, width, height, stride, row_elements};
  }
  /// Rows of one block each, without margins beside them: for kernels that hold a row in a
  /// register.
  [[nodiscard]] static Plane of_block_rows(Index width, Index height) {
    constexpr Index block = static_cast<Index>(kAlignment / sizeof(T));
    Plane plane;
    plane.data_ = make_aligned<T>(static_cast<std::size_t>((height + 2 * kMarginRows) * block));
    plane.view_ = {plane.data_.get() + kMarginRows * block, width, height, block, block};
    return plane;
  }

  [[nodiscard]] PlaneView<T> view() { return view_; }
  [[nodiscard]] ConstPlaneView<T> view() const { return view_; }

 private:
  AlignedArray<T> data_;
  PlaneView<T> view_;
};

using BitPlane = Plane<std::uint64_t>;

}  // namespace thinbench::detail
