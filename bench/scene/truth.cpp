#include "scene/truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "scene/coverage.hpp"

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

namespace {

/// From units, counted from the image's corner, to pixel centres at integers.
double pixel_coordinate(Unit at) {
  return static_cast<double>(at) / static_cast<double>(kUnitsPerPixel) - 0.5;
}

ScenePoint centre_of_mass(const Moments& sum) {
  return {sum.x / sum.area - 0.5, sum.y / sum.area - 0.5};
}

SceneBox box_of(const Contour& contour) {
  const Extent around = extent(contour);
  return {pixel_coordinate(around.low.x), pixel_coordinate(around.low.y),
          pixel_coordinate(around.high.x), pixel_coordinate(around.high.y)};
}

bool inside(const Contour& contour, ConstImageView image) {
  const Extent around = extent(contour);
  return around.low.x >= 0 && around.low.y >= 0 && around.high.x <= image.width * kUnitsPerPixel &&
         around.high.y <= image.height * kUnitsPerPixel;
}

/// Raster position of the first pixel of the given value that the outline covers in part; behind
/// all pixels where there is none.
Index first_pixel(const Contour& contour, ConstImageView binary, int value) {
  const PixelBox box = covered_box(contour, binary.width, binary.height);
  const CoverageMap map(box, {&contour, 1});
  for (Index y = 0; y < box.height; ++y) {
    const std::int16_t* coverage = map.row(y);
    const std::uint8_t* pixels = binary.row(box.y + y) + box.x;
    for (Index x = 0; x < box.width; ++x) {
      if (coverage[x] != 0 && pixels[x] == value) return (box.y + y) * binary.width + box.x + x;
    }
  }
  return binary.width * binary.height;
}

ScenePart measure_part(const PartShape& shape, ConstImageView binary) {
  Moments sum = moments(shape.body.outline);
  for (const NamedShape& hole : shape.holes) sum += moments(hole.outline);
  return {0,
          shape.body.kind,
          sum.area,
          centre_of_mass(sum),
          box_of(shape.body.outline),
          !inside(shape.body.outline, binary)};
}

SceneHole measure_hole(const NamedShape& shape, int part) {
  const Moments sum = moments(shape.outline);
  return {0, part, shape.kind, centre_of_mass(sum), -sum.area};
}

/// Things with the raster position of their first pixel.
template <class T>
using Placed = std::vector<std::pair<Index, T>>;

template <class T>
void sort_by_place(Placed<T>& items) {
  std::sort(items.begin(), items.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
}

template <class T>
std::vector<T> numbered(Placed<T> items) {
  sort_by_place(items);
  std::vector<T> result;
  for (auto& [place, item] : items) {
    item.id = static_cast<int>(result.size()) + 1;
    result.push_back(std::move(item));
  }
  return result;
}

}  // namespace

std::vector<PartShape> scaled_layout(const SceneOptions& options) {
  std::vector<PartShape> layout =
      options.kind == SceneKind::parts ? parts_layout() : border_touching_layout();
  for (PartShape& part : layout) {
    const Point offset = part.nudge * options.scale;
    part.body.outline = placed(part.body.outline, options.scale, offset);
    for (NamedShape& hole : part.holes) {
      hole.outline = reversed(placed(hole.outline, options.scale, offset));
    }
  }
  return layout;
}

Truth measure(const std::vector<PartShape>& layout, ConstImageView binary) {
  Placed<const PartShape*> shapes;
  for (const PartShape& shape : layout) {
    shapes.emplace_back(first_pixel(shape.body.outline, binary, 255), &shape);
  }
  sort_by_place(shapes);
  Truth truth;
  Placed<SceneHole> holes;
  for (const auto& [place, shape] : shapes) {
    truth.parts.push_back(measure_part(*shape, binary));
    const int id = static_cast<int>(truth.parts.size());
    truth.parts.back().id = id;
    for (const NamedShape& hole : shape->holes) {
      if (!inside(hole.outline, binary)) continue;
      holes.emplace_back(first_pixel(hole.outline, binary, 0), measure_hole(hole, id));
    }
  }
  truth.holes = numbered(std::move(holes));
  return truth;
}

}  // namespace thinbench::scene_detail
