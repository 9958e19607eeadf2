#include <cmath>

#include "graph.hpp"

namespace thinbench::reference {
namespace {

double squared_length(double x, double y) {
  return x * x + y * y;
}

/// From p to the segment from a to b.
double squared_distance(Pixel p, Pixel a, Pixel b, const Spacing& spacing) {
  const double line_x = (double{1} * b.x - a.x) * spacing.x;
  const double line_y = (double{1} * b.y - a.y) * spacing.y;
  const double p_x = (double{1} * p.x - a.x) * spacing.x;
  const double p_y = (double{1} * p.y - a.y) * spacing.y;
  const double along = line_x * p_x + line_y * p_y;
  if (along <= 0) return squared_length(p_x, p_y);
  if (along >= squared_length(line_x, line_y)) return squared_length(p_x - line_x, p_y - line_y);
  const double across = line_x * p_y - line_y * p_x;
  return across * across / squared_length(line_x, line_y);
}

/// Appends the points to keep after the first, up to the last.
void append(std::vector<Pixel>& kept, std::span<const Pixel> points, double tolerance,
            const Spacing& spacing) {
  double greatest = tolerance * tolerance;
  std::size_t farthest = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double distance = squared_distance(points[i], points.front(), points.back(), spacing);
    if (distance <= greatest) continue;
    greatest = distance;
    farthest = i;
  }
  if (farthest == 0) return kept.push_back(points.back());
  append(kept, points.first(farthest + 1), tolerance, spacing);
  append(kept, points.subspan(farthest), tolerance, spacing);
}

}  // namespace

std::vector<Pixel> polyline(std::span<const Pixel> points, double tolerance,
                            const Spacing& spacing) {
  std::vector<Pixel> kept;
  if (!points.empty()) kept.push_back(points.front());
  if (points.size() > 1) append(kept, points, tolerance, spacing);
  return kept;
}

}  // namespace thinbench::reference
