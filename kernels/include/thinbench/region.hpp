// One object or one hole of a binary image.
#pragma once

#include <cstdint>

namespace thinbench {

/// Area, exact sums of coordinates and bounding box of a set of pixels.
///
/// An object is an 8-connected component of the foreground, without its holes. A hole is a
/// 4-connected component of the background that does not touch the image border, without the
/// objects inside it. Everything outside the image is background, so background that touches the
/// border is not a hole.
///
/// Objects have ids 1, 2, 3, ... in raster order of their first pixels, and so do holes. A region's
/// id is its index in the list plus one.
struct Region {
  std::int64_t area = 0;
  std::int64_t sum_x = 0;
  std::int64_t sum_y = 0;
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t right = 0;  // inclusive, as is `bottom`
  std::int32_t bottom = 0;
  std::uint32_t enclosing_object = 0;  // for a hole the id of the object around it, else 0
  std::uint32_t reserved = 0;

  friend bool operator==(const Region&, const Region&) = default;

  /// The centre of mass; pixel centres have integer coordinates.
  [[nodiscard]] double centre_x() const {
    return static_cast<double>(sum_x) / static_cast<double>(area);
  }
  [[nodiscard]] double centre_y() const {
    return static_cast<double>(sum_y) / static_cast<double>(area);
  }
};

}  // namespace thinbench
