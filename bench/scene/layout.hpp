// What the scenes show, as data: parts as outlines with holes; and shorthands for shapes from whole
// pixels, measured from the image's top left corner.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
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

/// Parts that keep away from each other and from the image border.
[[nodiscard]] std::vector<PartShape> parts_layout();

/// Parts of which several touch the image border or are cut off by it, on all four sides.
[[nodiscard]] std::vector<PartShape> border_touching_layout();

[[nodiscard]] constexpr Unit px(int pixels) {
  return pixels * kUnitsPerPixel;
}
[[nodiscard]] constexpr Point px(int x, int y) {
  return {px(x), px(y)};
}

/// A circle by its centre and its diameter.
[[nodiscard]] inline NamedShape disc(int x, int y, int diameter, const char* kind = "circle") {
  return {kind, circle(px(x, y), px(diameter) / 2)};
}

/// An upright rectangle between two corners, with rounded corners.
[[nodiscard]] inline NamedShape box(const char* kind, Point low, Point high, Unit radius = 0) {
  const Point size = high - low;
  return {kind,
          rectangle({{low.x + size.x / 2, low.y + size.y / 2}, size.x / 2, size.y / 2, radius})};
}

/// A rectangle with fully round ends: a pin, or a slot as a hole. `axis` as in RectangleSpec.
[[nodiscard]] inline NamedShape stadium(const char* kind, Point centre, int length, int width,
                                        Point axis) {
  return {kind, rectangle({centre, px(length) / 2, px(width) / 2, px(width) / 2, axis})};
}
[[nodiscard]] inline NamedShape slot(int x, int y, int length, int width, Point axis = {1, 0}) {
  return stadium("slot", px(x, y), length, width, axis);
}

/// A band of constant width along an upright polyline.
[[nodiscard]] inline NamedShape band(const char* kind, std::vector<Point> points, int width,
                                     int bend_radius) {
  return {kind, stroke({std::move(points), px(width) / 2, px(bend_radius)})};
}

/// A square hole by its centre and side.
[[nodiscard]] inline NamedShape square(int x, int y, int side) {
  return {"square", rectangle({px(x, y), px(side) / 2, px(side) / 2})};
}

/// A polygon by its corners, each with the radius that rounds it.
struct PixelCorner {
  int x = 0;
  int y = 0;
  int radius = 0;
};
[[nodiscard]] inline NamedShape cut_out(const char* kind,
                                        std::initializer_list<PixelCorner> corners) {
  std::vector<Corner> list;
  for (const auto& [x, y, radius] : corners) list.push_back({px(x, y), px(radius)});
  return {kind, polygon(list)};
}

}  // namespace thinbench::scene_detail
