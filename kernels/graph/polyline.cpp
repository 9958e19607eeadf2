#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/checks.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

/// From one pixel to another; coordinates may be farther apart than 32 bits.
struct Step {
  double x;
  double y;

  Step(Pixel from, Pixel to)
      : x(static_cast<double>(to.x) - from.x), y(static_cast<double>(to.y) - from.y) {}
};

double product(const Step& a, const Step& b) {
  return a.x * b.x + a.y * b.y;
}

/// The square of the distance from p to the segment from a to b. Exactly 0 on it: sums of products
/// of coordinates of images have no rounding error.
double squared_distance(Pixel p, Pixel a, Pixel b) {
  const Step line(a, b);
  const Step to_p(a, p);
  const double along = product(line, to_p);
  const double squared_length = product(line, line);
  if (along <= 0) return product(to_p, to_p);
  if (along >= squared_length) return product(Step(b, p), Step(b, p));
  const double across = line.x * to_p.y - line.y * to_p.x;
  return across * across / squared_length;
}

/// Marks the points to keep between each pair that is already kept.
std::vector<bool> kept_points(std::span<const Pixel> points, double tolerance) {
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> to_split = {{0, points.size() - 1}};
  while (!to_split.empty()) {
    const auto [first, last] = to_split.back();
    to_split.pop_back();
    std::size_t farthest = first;
    double greatest = tolerance * tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = squared_distance(points[i], points[first], points[last]);
      if (distance <= greatest) continue;
      greatest = distance;
      farthest = i;
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    to_split.emplace_back(first, farthest);
    to_split.emplace_back(farthest, last);
  }
  return kept;
}

}  // namespace

double length_of(const GraphEdge& edge) {
  return edge.straight_steps + edge.diagonal_steps * std::sqrt(2.0);
}

std::vector<Pixel> points_of(const Graph& graph, const GraphEdge& edge) {
  std::vector<Pixel> points = {edge.start};
  const std::span<const Pixel> line = graph.pixels_of(edge);
  points.insert(points.end(), line.begin(), line.end());
  points.push_back(edge.stop);
  return points;
}

std::vector<Pixel> polyline(std::span<const Pixel> points, double tolerance) {
  detail::require(tolerance >= 0 && std::isfinite(tolerance),
                  "tolerance: expected a number of at least 0, got " + std::to_string(tolerance));
  std::vector<Pixel> result;
  if (points.empty()) return result;
  const std::vector<bool> kept = kept_points(points, tolerance);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) result.push_back(points[i]);
  }
  return result;
}

}  // namespace thinbench
