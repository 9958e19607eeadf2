// The graph of a skeleton, pruning, polylines of edges and main paths, in plain code.
#pragma once

#include <cstddef>
#include <vector>

#include "thinbench/graph.hpp"

namespace thinbench::reference {

/// Nodes by flood filling, edges by walking, pixel after pixel; see thinbench/graph.hpp for what
/// they are and for their order.
[[nodiscard]] Graph skeleton_graph(ConstImageView skeleton);

/// Round after round, each a new graph, until nothing is removed; see thinbench/graph.hpp.
void prune(ConstImageView skeleton, ImageView destination, const Pruning& pruning);

/// Douglas and Peucker as published: splits at the first of the farthest points, for which it
/// measures every point.
[[nodiscard]] std::vector<Pixel> polyline(std::span<const Pixel> points, double tolerance,
                                          const Spacing& spacing = {});

/// A main path from point to point: first the nodes have numbers, then the pixels of edges.
struct MainPath {
  double length;
  std::size_t first;
  std::size_t last;
};

/// Of each component, by the distances of all pixels from all others; see
/// thinbench/graph_paths.hpp.
[[nodiscard]] std::vector<MainPath> main_paths(ConstImageView skeleton,
                                               const Spacing& spacing = {});

}  // namespace thinbench::reference
