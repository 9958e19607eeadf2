#include <algorithm>

#include "harness/splitmix64.hpp"
#include "harness/test_images.hpp"

namespace thinbench {
namespace {

/// Positions are in 1/32 of a pixel: up to sides of 1024 pixels nothing overflows.
constexpr std::int64_t kUnits = 32;

struct Point {
  std::int64_t x, y;
};

constexpr std::int64_t dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}

constexpr Point from_to(Point a, Point b) {
  return {b.x - a.x, b.y - a.y};
}

bool is_near(Point p, Point a, Point b, std::int64_t radius) {
  const Point along = from_to(a, b);
  const Point seen = from_to(a, p);
  const std::int64_t length2 = dot(along, along);
  const std::int64_t foot = dot(along, seen);
  if (foot <= 0) return dot(seen, seen) <= radius * radius;
  if (foot >= length2) {
    const Point beyond = from_to(b, p);
    return dot(beyond, beyond) <= radius * radius;
  }
  const std::int64_t twice_area = along.x * seen.y - along.y * seen.x;
  return twice_area * twice_area <= radius * radius * length2;
}

/// Draws the pixels whose centres lie within `radius` of the line from `a` to `b`.
void draw_line(const ImageView& image, Point a, Point b, std::int64_t radius) {
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [top, bottom] = std::minmax(a.y, b.y);
  const Index last_x = std::min<Index>(image.width - 1, (right + radius) / kUnits);
  const Index last_y = std::min<Index>(image.height - 1, (bottom + radius) / kUnits);
  for (Index y = std::max<Index>(0, (top - radius) / kUnits); y <= last_y; ++y) {
    for (Index x = std::max<Index>(0, (left - radius) / kUnits); x <= last_x; ++x) {
      const Point centre = {x * kUnits + kUnits / 2, y * kUnits + kUnits / 2};
      if (is_near(centre, a, b, radius)) image.row(y)[x] = 255;
    }
  }
}

void draw_strokes(const ImageView& image, Random random) {
  const std::int64_t side = image.width * kUnits;
  const auto below = [&random](std::int64_t count) {
    return static_cast<std::int64_t>(random.next() % static_cast<std::uint64_t>(count));
  };
  const std::int64_t radius = side / 28 + below(side / 28 + 1);
  const auto coordinate = [&] { return side / 7 + below(side * 5 / 7 + 1); };
  const auto point = [&] {
    const std::int64_t x = coordinate();
    return Point{x, coordinate()};
  };
  const std::int64_t points = 3 + below(4);
  Point last = point();
  for (std::int64_t i = 1; i < points; ++i) {
    const Point next = point();
    draw_line(image, last, next, radius);
    last = next;
  }
}

}  // namespace

ByteImage stroke_images(Index count, Index side, std::uint64_t seed) {
  ByteImage images(side, count * side);
  for (Index i = 0; i < count; ++i) {
    const ImageView all = images.view();
    draw_strokes({all.row(i * side), side, side, all.stride},
                 Random(splitmix64(seed, static_cast<std::uint64_t>(i))));
  }
  return images;
}

}  // namespace thinbench
