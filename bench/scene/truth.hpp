// Parts and holes of a scene with their true geometry and their ids; area, centre of mass and
// extent of outlines in closed form.
#pragma once

#include <vector>

#include "scene/layout.hpp"
#include "scene/scene.hpp"
#include "scene/shapes.hpp"
#include "support/byte_image.hpp"

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

/// The layout at its final place and size: outlines clockwise around parts, anticlockwise around
/// holes, nudges and scale applied.
[[nodiscard]] std::vector<PartShape> scaled_layout(const SceneOptions& options);

struct Truth {
  std::vector<ScenePart> parts;
  std::vector<SceneHole> holes;
};

/// Measures a scaled layout; the binary image only serves to number parts and holes.
[[nodiscard]] Truth measure(const std::vector<PartShape>& layout, ConstImageView binary);

}  // namespace thinbench::scene_detail
