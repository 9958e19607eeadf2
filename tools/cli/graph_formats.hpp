// The graph of a skeleton as a list for people, JSON, GeoJSON and lines over its image.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/tables.hpp"
#include "images/overlay.hpp"
#include "images/pixels.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/graph_paths.hpp"

namespace thinbench {

/// x' = a x + b y + c, y' = d x + e y + f. The centre of the first pixel is at x = 0.5, y = 0.5.
using AffineTransform = std::array<double, 6>;

struct FoundGraph {
  ImagePage page;
  Index width;
  Index height;
  Graph graph;
  std::vector<EdgeWidths> widths;         // of each edge
  std::vector<std::vector<Pixel>> lines;  // polylines of the edges
  Spacing spacing;
  std::string unit;
  std::vector<GraphPath> main_paths;                 // of the components, if asked for
  std::vector<std::vector<Pixel>> main_lines;        // polylines of these
  std::vector<std::int32_t> labels;                  // of the nodes, if the image has labels
  std::optional<GeoReference> place = std::nullopt;  // of GeoJSON, if the image is a map
};

/// Nodes and edges have the ids 1, 2, 3, ... everywhere. Infinite widths are null in JSON. Texts
/// end with a newline.
[[nodiscard]] std::string graph_list(const FoundGraph& found);
[[nodiscard]] nlohmann::ordered_json graph_json(const FoundGraph& found);
/// A row for each edge with the column names of skan's summarize(): numbers of nodes and of
/// skeletons, which are components, count from 0 there. A CSV file.
[[nodiscard]] std::string graph_summary(const FoundGraph& found);
/// A Point for each node, a LineString for each edge and each main path.
[[nodiscard]] std::string graph_geojson(const FoundGraph& found, const AffineTransform& transform);
[[nodiscard]] Overlay graph_overlay(const FoundGraph& found);

}  // namespace thinbench
