// Main paths of links between nodes that have points, too.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "thinbench/graph_paths.hpp"

namespace thinbench::detail {

/// How far the points of a link are from its node `from`, along it: ascending numbers between 0 and
/// its length.
using PointsOf = std::function<std::vector<double>(std::uint32_t link)>;

/// For each component, the longest of the shortest paths between its nodes and points. Asks for the
/// points of components with cycles only: elsewhere, nodes are farthest apart. Throws
/// std::invalid_argument for links that do not fit.
[[nodiscard]] std::vector<GraphPath> main_paths(std::uint32_t nodes, std::span<const Link> links,
                                                const PointsOf& points_of);

/// Those of a graph with so many nodes; the edges have their pixels in the list.
[[nodiscard]] std::vector<GraphPath> main_paths(std::uint32_t nodes,
                                                std::span<const GraphEdge> edges,
                                                std::span<const Pixel> pixels,
                                                const Spacing& spacing);

}  // namespace thinbench::detail
