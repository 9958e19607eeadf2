// What the scenes show: parts as outlines with holes, as data.
#pragma once

#include <string>
#include <vector>

#include "scene/shapes.hpp"

namespace thinbench::scene_detail {

/// Width and height of the scenes at scale 1, in pixels.
inline constexpr Unit kSceneWidth = 510;
inline constexpr Unit kSceneHeight = 412;

/// A named outline, clockwise.
struct NamedShape {
  std::string kind;
  Contour outline;
};

/// A part with its holes. `nudge` moves the whole part by some units off the pixel grid, so that
/// its straight edges cut through pixels as they do in a camera image.
struct PartShape {
  NamedShape body;
  std::vector<NamedShape> holes;
  Point nudge;
};

/// Parts that keep away from each other and from the frame.
[[nodiscard]] std::vector<PartShape> parts_layout();

/// Parts of which several touch the frame or are cut off by it, on all four sides.
[[nodiscard]] std::vector<PartShape> frame_touching_layout();

}  // namespace thinbench::scene_detail
