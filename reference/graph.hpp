// The graph of a skeleton, and polylines of its edges, in plain code.
#pragma once

#include "thinbench/graph.hpp"

namespace thinbench::reference {

/// Nodes by flood filling, edges by walking, pixel after pixel; see thinbench/graph.hpp for what
/// they are and for their order.
[[nodiscard]] Graph skeleton_graph(ConstImageView skeleton);

/// Douglas and Peucker as published: splits at the first of the farthest points, for which it
/// measures every point.
[[nodiscard]] std::vector<Pixel> polyline(std::span<const Pixel> points, double tolerance);

}  // namespace thinbench::reference
