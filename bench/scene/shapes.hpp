// Closed outlines made of straight lines and circular arcs, all in integer coordinates.
//
// Coordinates count units of 1/32 pixel from the top left corner of the image, x to the right and y
// downwards, so the image covers 0 .. 32 * width by 0 .. 32 * height and pixel (x, y) is the square
// 32 x .. 32 (x + 1) by 32 y .. 32 (y + 1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace thinbench::scene_detail {

/// A length or coordinate in 1/32 pixel.
using Unit = std::int64_t;

inline constexpr Unit kUnitsPerPixel = 32;

struct Point {
  Unit x = 0;
  Unit y = 0;

  friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point operator*(Point p, Unit factor) { return {p.x * factor, p.y * factor}; }
  friend constexpr bool operator==(Point a, Point b) = default;
};

/// One piece of an outline: a straight line where `radius` is 0, else an arc of the circle around
/// `centre` that stays on one side of the vertical line through it. Either way y never turns back
/// along an edge, and both ends lie on the circle exactly.
struct Edge {
  Point from;
  Point to;
  Point centre;
  Unit radius = 0;
};

/// Edges that follow each other and close. Clockwise on the screen around material, anticlockwise
/// around a hole.
using Contour = std::vector<Edge>;

/// Corner of a polygon; a positive radius replaces the corner by a quarter of a circle. That needs
/// a right angle, sides of integer length, and a radius that divides along both sides to whole
/// units.
struct Corner {
  Point at;
  Unit radius = 0;
};

/// Polygon through the given corners, in their order.
[[nodiscard]] Contour polygon(std::span<const Corner> corners);

/// Circle, clockwise.
[[nodiscard]] Contour circle(Point centre, Unit radius);

/// Rectangle around `centre` with corners of the given radius, clockwise. `axis` is the unscaled
/// direction of its length, an integer vector of integer length such as (1, 0) or (3, 4).
struct RectangleSpec {
  Point centre;
  Unit half_length = 0;
  Unit half_width = 0;
  Unit radius = 0;
  Point axis = {1, 0};
};
[[nodiscard]] Contour rectangle(const RectangleSpec& spec);

/// Band along an upright polyline (every turn a right angle, none straight on), clockwise: its
/// bends follow circles, its ends are half circles. At least two points; `bend_radius`, that of the
/// middle line, is larger than `half_width`.
struct StrokeSpec {
  std::vector<Point> points;
  Unit half_width = 0;
  Unit bend_radius = 0;
};
[[nodiscard]] Contour stroke(const StrokeSpec& spec);

/// Outlines around a centre, with corners at multiples of 1/96 turn; clockwise.
[[nodiscard]] Contour hexagon(Point centre, Unit corner_radius);
/// `teeth` is 16 or 24; teeth are trapezoids between the two radii.
[[nodiscard]] Contour gear(Point centre, int teeth, Unit root_radius, Unit tip_radius);

/// Point at `step`/96 of a turn, clockwise from the direction of x, rounded to whole units.
[[nodiscard]] Point on_circle(Point centre, Unit radius, int step);

/// The same outline the other way round.
[[nodiscard]] Contour reversed(const Contour& contour);

/// The outline magnified by `factor` and then moved by `offset`.
[[nodiscard]] Contour placed(const Contour& contour, Unit factor, Point offset);

}  // namespace thinbench::scene_detail
