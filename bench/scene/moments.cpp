#include "scene/moments.hpp"

#include <algorithm>
#include <cmath>

namespace thinbench::scene_detail {
namespace {

double pixels(Unit value) {
  return static_cast<double>(value) / static_cast<double>(kUnitsPerPixel);
}

struct RealPoint {
  double x = 0;
  double y = 0;
};

RealPoint pixels(Point point) {
  return {pixels(point.x), pixels(point.y)};
}

Moments line_moments(const Edge& edge) {
  const auto [x0, y0] = pixels(edge.from);
  const auto [x1, y1] = pixels(edge.to);
  return {(x0 * y1 - x1 * y0) / 2, (y1 - y0) * (x0 * x0 + x0 * x1 + x1 * x1) / 6,
          -(x1 - x0) * (y0 * y0 + y0 * y1 + y1 * y1) / 6};
}

/// Angle from `from` to `to` seen from the centre; arcs are shorter than half a turn or equal to
/// it, and one of half a turn keeps to one side of the vertical.
double swept_angle(RealPoint from, RealPoint to) {
  return std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
}

Moments arc_moments(const Edge& edge) {
  const double r = pixels(edge.radius);
  const auto [cx, cy] = pixels(edge.centre);
  const RealPoint a = pixels(edge.from - edge.centre);
  const RealPoint b = pixels(edge.to - edge.centre);
  const double sector = r * r * swept_angle(a, b);
  // With (c, s) = r (cos t, sin t), these are the integrals of c ds, c^2 ds, -s dc and -s^2 dc
  // along the arc, which x dy and x^2 dy, -y dx and -y^2 dx expand into.
  const double overlap = b.x * b.y - a.x * a.y;
  const double c1 = (sector + overlap) / 2;
  const double s1 = (sector - overlap) / 2;
  const double c2 = r * r * (b.y - a.y) - (b.y * b.y * b.y - a.y * a.y * a.y) / 3;
  const double s2 = -r * r * (b.x - a.x) + (b.x * b.x * b.x - a.x * a.x * a.x) / 3;
  return {(sector + cx * (b.y - a.y) - cy * (b.x - a.x)) / 2,
          (cx * cx * (b.y - a.y) + 2 * cx * c1 + c2) / 2,
          (-cy * cy * (b.x - a.x) + 2 * cy * s1 + s2) / 2};
}

}  // namespace

Moments& Moments::operator+=(const Moments& other) {
  area += other.area;
  x += other.x;
  y += other.y;
  return *this;
}

Moments moments(const Contour& contour) {
  Moments sum;
  for (const Edge& edge : contour) sum += edge.radius > 0 ? arc_moments(edge) : line_moments(edge);
  return sum;
}

Extent extent(const Contour& contour) {
  Extent box{contour.front().from, contour.front().from};
  for (const Edge& edge : contour) {
    box.low = {std::min(box.low.x, edge.to.x), std::min(box.low.y, edge.to.y)};
    box.high = {std::max(box.high.x, edge.to.x), std::max(box.high.y, edge.to.y)};
    // An arc may bulge sideways beyond both of its ends.
    const Point a = edge.from - edge.centre;
    const Point b = edge.to - edge.centre;
    if (edge.radius == 0 || a.y * b.y >= 0) continue;
    const Unit side = a.x + b.x > 0 ? edge.radius : -edge.radius;
    box.low.x = std::min(box.low.x, edge.centre.x + side);
    box.high.x = std::max(box.high.x, edge.centre.x + side);
  }
  return box;
}

}  // namespace thinbench::scene_detail
