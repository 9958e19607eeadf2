#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

#include "core/checks.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

/// From one pixel to another; coordinates may be farther apart than 32 bits.
struct Step {
  double x;
  double y;

  Step(Pixel from, Pixel to, const Spacing& spacing = {})
      : x((static_cast<double>(to.x) - from.x) * spacing.x),
        y((static_cast<double>(to.y) - from.y) * spacing.y) {}
};

double product(const Step& a, const Step& b) {
  return a.x * b.x + a.y * b.y;
}

/// Distances from the points of a line to the segment from a to b, as squares times `scale`: a
/// convex function, and a growing function of the exact distance even where it is rounded, as
/// products of coordinates of images are exact.
struct Segment {
  Pixel a;
  Pixel b;
  Spacing spacing;
  Step line{a, b, spacing};
  double squared_length = product(line, line);
  double scale = a == b ? 1 : squared_length;

  [[nodiscard]] double scaled_distance(Pixel p) const {
    const Step to_p(a, p, spacing);
    const double along = product(line, to_p);
    if (along <= 0) return product(to_p, to_p) * scale;
    const Step beyond(b, p, spacing);
    if (along >= squared_length) return product(beyond, beyond) * scale;
    const double across = line.x * to_p.y - line.y * to_p.x;
    return across * across;
  }
};

bool is_before(Pixel a, Pixel b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

/// The points of half a convex hull: those where a chain through sorted points turns to one side.
template <class Iterator>
std::vector<Pixel> chain(Iterator begin, Iterator end) {
  std::vector<Pixel> hull;
  for (; begin != end; ++begin) {
    while (hull.size() >= 2) {
      const Step last(hull[hull.size() - 2], hull.back());
      const Step next(hull.back(), *begin);
      if (last.x * next.y - last.y * next.x > 0) break;
      hull.pop_back();
    }
    hull.push_back(*begin);
  }
  return hull;
}

/// The corners of the convex hull, sorted.
std::vector<Pixel> convex_hull(const std::vector<Pixel>& sorted) {
  const std::vector<Pixel> below = chain(sorted.begin(), sorted.end());
  std::vector<Pixel> above = chain(sorted.rbegin(), sorted.rend());
  std::reverse(above.begin(), above.end());
  std::vector<Pixel> hull;
  std::set_union(below.begin(), below.end(), above.begin(), above.end(), std::back_inserter(hull),
                 is_before);
  return hull;
}

/// The points of a line, and the convex hulls of blocks of 2^k of them, each of two blocks of half
/// the size. A point that is farthest from a segment is a corner of the hull of its block, so few
/// points of a long line are looked at: at most as many as hulls have corners, for each of O(log n)
/// blocks. (Hulls of n pixels of a line have O(n^(2/3)) corners, mostly a few.)
class FarthestPoint {
 public:
  FarthestPoint(std::span<const Pixel> points, const Spacing& spacing)
      : points_(points), spacing_(spacing) {
    while (points.size() >> (kPlain + hulls_.size() + 1) > 0) add_level();
  }

  /// The first of the points between those with the numbers `first` and `last` that are farthest
  /// from the segment between both, if that is more than the square root of `limit`; else `first`.
  [[nodiscard]] std::size_t between(std::size_t first, std::size_t last, double limit) const {
    const Segment segment = {points_[first], points_[last], spacing_};
    double greatest = 0;
    std::size_t level = 0;
    std::size_t block = first;
    for (std::size_t i = first + 1, fits = 0; i < last; i += std::size_t{1} << fits) {
      fits = 0;
      while ((i >> fits) % 2 == 0 && (last - i) >> (fits + 1) > 0) ++fits;
      const double distance = greatest_of(segment, fits, i >> fits);
      if (distance <= greatest) continue;
      greatest = distance;
      level = fits;
      block = i >> fits;
    }
    if (!(greatest / segment.scale > limit)) return first;
    while (level > 0) {
      --level;
      block *= 2;
      if (greatest_of(segment, level, block) < greatest) ++block;
    }
    return block;
  }

 private:
  static constexpr std::size_t kPlain = 5;  // blocks up to 2^5 points are scanned, not worth a hull

  void add_level() {
    const std::size_t below = kPlain + hulls_.size();
    std::vector<std::vector<Pixel>> level(points_.size() >> (below + 1));
    for (std::size_t block = 0; block < level.size(); ++block) {
      std::vector<Pixel> both;
      for (const std::size_t half : {2 * block, 2 * block + 1}) {
        both.insert(both.end(), corners(below, half).begin(), corners(below, half).end());
      }
      std::sort(both.begin(), both.end(), is_before);
      level[block] = convex_hull(both);
    }
    hulls_.push_back(std::move(level));
  }

  [[nodiscard]] std::span<const Pixel> corners(std::size_t level, std::size_t block) const {
    if (level <= kPlain) return points_.subspan(block << level, std::size_t{1} << level);
    return hulls_[level - kPlain - 1][block];
  }

  [[nodiscard]] double greatest_of(const Segment& segment, std::size_t level,
                                   std::size_t block) const {
    double greatest = 0;
    for (const Pixel p : corners(level, block)) {
      greatest = std::max(greatest, segment.scaled_distance(p));
    }
    return greatest;
  }

  std::span<const Pixel> points_;
  Spacing spacing_;
  std::vector<std::vector<std::vector<Pixel>>> hulls_;  // [level - kPlain - 1][block]
};

/// Marks the points to keep between each pair that is already kept.
std::vector<bool> kept_points(std::span<const Pixel> points, double tolerance,
                              const Spacing& spacing) {
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  const FarthestPoint farthest_point(points, spacing);
  std::vector<std::pair<std::size_t, std::size_t>> to_split = {{0, points.size() - 1}};
  while (!to_split.empty()) {
    const auto [first, last] = to_split.back();
    to_split.pop_back();
    const std::size_t farthest = farthest_point.between(first, last, tolerance * tolerance);
    if (farthest == first) continue;
    kept[farthest] = true;
    to_split.emplace_back(first, farthest);
    to_split.emplace_back(farthest, last);
  }
  return kept;
}

}  // namespace

double length_of(const Steps& steps, const Spacing& spacing) {
  const double diagonal = std::sqrt(spacing.x * spacing.x + spacing.y * spacing.y);
  return steps.horizontal * spacing.x + steps.vertical * spacing.y + steps.diagonal * diagonal;
}

double length_of(std::span<const Pixel> points, const Spacing& spacing) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Step step(points[i - 1], points[i], spacing);
    length += std::hypot(step.x, step.y);
  }
  return length;
}

std::vector<Pixel> points_of(const Graph& graph, const GraphEdge& edge) {
  std::vector<Pixel> points = {edge.start};
  const std::span<const Pixel> line = graph.pixels_of(edge);
  points.insert(points.end(), line.begin(), line.end());
  points.push_back(edge.stop);
  return points;
}

std::vector<Pixel> polyline(std::span<const Pixel> points, double tolerance,
                            const Spacing& spacing) {
  detail::require_not_negative("tolerance", tolerance);
  detail::require_spacing(spacing);
  std::vector<Pixel> result;
  if (points.empty()) return result;
  const std::vector<bool> kept = kept_points(points, tolerance, spacing);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) result.push_back(points[i]);
  }
  return result;
}

}  // namespace thinbench
