// Area, centre of mass and extent of outlines, in closed form.
#pragma once

#include "scene/shapes.hpp"

namespace thinbench::scene_detail {

/// Integrals over the inside of a contour, in pixels, measured from the image's top left corner:
/// of 1, of x and of y. Negative around holes, so those of one part simply add up.
struct Moments {
  double area = 0;
  double x = 0;
  double y = 0;

  Moments& operator+=(const Moments& other);
};

/// By Green's theorem along the lines and arcs: exact up to the rounding of double.
[[nodiscard]] Moments moments(const Contour& contour);

/// Smallest axis-parallel rectangle around an outline, in units.
struct Extent {
  Point low;
  Point high;
};
[[nodiscard]] Extent extent(const Contour& contour);

}  // namespace thinbench::scene_detail
