// Memory of planes.
#pragma once

#include <cstdint>

#include "image/byte_image.hpp"
#include "image/plane_view.hpp"

namespace thinbench::detail {

/// Owns a plane. Rows start on cache lines; margin and padding are zero.
template <class T>
class Plane {
 public:
  Plane() = default;
  Plane(Index width, Index height);

  [[nodiscard]] PlaneView<T> view() { return view_; }
  [[nodiscard]] ConstPlaneView<T> view() const { return view_; }

 private:
  AlignedArray<T> data_;
  PlaneView<T> view_;
};

extern template class Plane<std::uint8_t>;
extern template class Plane<std::uint64_t>;

using BytePlane = Plane<std::uint8_t>;
using BitPlane = Plane<std::uint64_t>;

}  // namespace thinbench::detail
