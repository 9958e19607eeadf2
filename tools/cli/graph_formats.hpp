// The graph of a skeleton as a list for people, JSON, CSV, GeoJSON and SVG. All end with a newline.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "thinbench/graph.hpp"

namespace thinbench {

/// x' = a x + b y + c, y' = d x + e y + f. The centre of the first pixel is at x = 0.5, y = 0.5.
using AffineTransform = std::array<double, 6>;

struct FoundGraph {
  std::string file;
  Index width;
  Index height;
  Graph graph;
  std::vector<EdgeWidths> widths;         // of each edge
  std::vector<std::vector<Pixel>> lines;  // polylines of the edges
};

/// Nodes and edges have the ids 1, 2, 3, ... everywhere. Infinite widths are null in JSON and empty
/// in CSV.
[[nodiscard]] std::string graph_list(const FoundGraph& found);
[[nodiscard]] std::string graph_json(const FoundGraph& found);
/// A row for each edge.
[[nodiscard]] std::string graph_csv(const FoundGraph& found);
/// A Point for each node, a LineString for each edge.
[[nodiscard]] std::string graph_geojson(const FoundGraph& found, const AffineTransform& transform);
/// Lines and nodes drawn over an image in PNG format.
[[nodiscard]] std::string graph_svg(const FoundGraph& found, const std::string& png);

}  // namespace thinbench
