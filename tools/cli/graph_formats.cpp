#include "cli/graph_formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/text.hpp"
#include "thinbench/graph_parts.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

struct Point {
  double x;
  double y;
};

/// The mean of its pixels.
Point centre_of(const Graph& graph, const GraphNode& node) {
  Point sum = {0, 0};
  for (const Pixel p : graph.pixels_of(node)) sum = {sum.x + p.x, sum.y + p.y};
  return {sum.x / node.pixel_count, sum.y / node.pixel_count};
}

std::string_view kind_of(const GraphNode& node) {
  return kNodeKindNames[static_cast<std::size_t>(node.kind)];
}

double chord_of(const GraphEdge& edge, const Spacing& spacing) {
  return std::hypot((static_cast<double>(edge.stop.x) - edge.start.x) * spacing.x,
                    (static_cast<double>(edge.stop.y) - edge.start.y) * spacing.y);
}

/// How many ends of edges each node has.
std::vector<std::size_t> degrees_of(const Graph& graph) {
  std::vector<std::size_t> degrees(graph.nodes.size());
  for (const GraphEdge& edge : graph.edges) {
    ++degrees[edge.from];
    ++degrees[edge.to];
  }
  return degrees;
}

/// "3 nodes (2 ends, 1 junction)".
std::string nodes_text(const Graph& graph) {
  std::string text = counted(graph.nodes.size(), "node");
  const char* before = " (";
  for (std::size_t kind = 0; kind < kNodeKindNames.size(); ++kind) {
    const auto count = static_cast<std::size_t>(
        std::ranges::count(graph.nodes, static_cast<NodeKind>(kind), &GraphNode::kind));
    if (count == 0) continue;
    const auto of_kind = static_cast<NodeKind>(kind);
    const bool is_noun = of_kind != NodeKind::isolated && of_kind != NodeKind::given;
    const std::string name(kNodeKindNames[kind]);
    text += before + (is_noun ? counted(count, name) : fmt::format("{} {}", count, name));
    before = ", ";
  }
  return graph.nodes.empty() ? text : text + ")";
}

Json properties_of(const FoundGraph& found, std::size_t i) {
  const GraphEdge& edge = found.graph.edges[i];
  const EdgeWidths& width = found.widths[i];
  Json properties = {{"id", i + 1},
                     {"from", edge.from + 1},
                     {"to", edge.to + 1},
                     {"pixels", edge.pixel_count},
                     {"length", length_of(edge, found.spacing)},
                     {"smoothed_length", length_of(found.lines[i], found.spacing)},
                     {"chord", chord_of(edge, found.spacing)},
                     {"width_mean", width.mean},
                     {"width_median", width.median},
                     {"width_min", width.min},
                     {"width_max", width.max}};
  if (!found.labels.empty()) properties["label"] = found.labels[edge.from];
  return properties;
}

Json node_properties_of(const FoundGraph& found, std::size_t i, std::size_t degree) {
  Json properties = {{"id", i + 1}, {"kind", kind_of(found.graph.nodes[i])}, {"degree", degree}};
  if (!found.labels.empty()) properties["label"] = found.labels[i];
  return properties;
}

template <class PositionOf>
Json positions(const std::vector<Pixel>& line, const PositionOf& position_of) {
  Json list = Json::array();
  for (const Pixel p : line) list.push_back(position_of(p));
  return list;
}

Json feature(std::size_t id, const char* type, Json coordinates, Json properties) {
  return {{"type", "Feature"},
          {"id", id},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}},
          {"properties", std::move(properties)}};
}

Json spacing_json(const FoundGraph& found) {
  return {found.spacing.x, found.spacing.y};
}

/// Numbers as ids.
Json ids_of(const std::vector<std::uint32_t>& numbers) {
  Json ids = Json::array();
  for (const std::uint32_t number : numbers) ids.push_back(number + 1);
  return ids;
}

Json pixel_json(Pixel p) {
  return {p.x, p.y};
}

/// What a main path has in every format: where it begins and ends within an edge there is no node.
Json main_path_properties(const GraphPath& path, std::size_t i) {
  return {{"id", i + 1},
          {"from", path.first_point ? Json() : Json(path.nodes.front() + 1)},
          {"to", path.last_point ? Json() : Json(path.nodes.back() + 1)},
          {"length", path.length}};
}

Json main_paths_json(const FoundGraph& found) {
  Json paths = Json::array();
  for (std::size_t i = 0; i < found.main_paths.size(); ++i) {
    const GraphPath& path = found.main_paths[i];
    paths.push_back(main_path_properties(path, i));
    paths.back()["nodes"] = ids_of(path.nodes);
    paths.back()["edges"] = ids_of(path.edges);
    paths.back()["points"] = positions(found.main_lines[i], pixel_json);
  }
  return paths;
}

/// Where a main path begins or ends: "node 3", or "edge 2 at (14, 5)".
std::string end_text(const FoundGraph& found, std::size_t i, bool is_first) {
  const GraphPath& path = found.main_paths[i];
  if (!(is_first ? path.first_point : path.last_point)) {
    return fmt::format("node {}", (is_first ? path.nodes.front() : path.nodes.back()) + 1);
  }
  const Pixel p = is_first ? found.main_lines[i].front() : found.main_lines[i].back();
  return fmt::format("edge {} at ({}, {})", (is_first ? path.edges.front() : path.edges.back()) + 1,
                     p.x, p.y);
}

/// The edges that a path takes as a whole.
std::span<const std::uint32_t> whole_edges(const GraphPath& path) {
  const std::span<const std::uint32_t> edges = path.edges;
  if (path.nodes.empty()) return {};
  return edges.subspan(path.first_point ? 1 : 0, path.nodes.size() - 1);
}

/// What a path takes of the edges in which it begins and ends, as paths.
std::vector<GraphPath> parts_of(const GraphPath& path) {
  if (path.nodes.empty()) return {path};
  std::vector<GraphPath> parts;
  if (path.first_point) {
    parts.push_back({0, {path.nodes.front()}, {path.edges.front()}, path.first_point});
  }
  if (path.last_point) {
    parts.push_back({0, {path.nodes.back()}, {path.edges.back()}, {}, path.last_point});
  }
  return parts;
}

Json unit_json(const FoundGraph& found) {
  return found.unit.empty() ? Json() : Json(found.unit);
}

}  // namespace

std::string graph_list(const FoundGraph& found) {
  const Graph& graph = found.graph;
  std::string text = nodes_text(graph) + ", " + counted(graph.edges.size(), "edge") + '\n';
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto [x, y] = centre_of(graph, graph.nodes[i]);
    text += fmt::format("node {}: {} at ({:.2f}, {:.2f})\n", i + 1, kind_of(graph.nodes[i]), x, y);
  }
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const GraphEdge& edge = graph.edges[i];
    const EdgeWidths& width = found.widths[i];
    text += fmt::format("edge {}: node {} to {}, length {:.2f}, width {:.2f} ({:.2f} to {:.2f})",
                        i + 1, edge.from + 1, edge.to + 1, length_of(edge, found.spacing),
                        width.mean, width.min, width.max);
    text += found.labels.empty() ? "\n" : fmt::format(", label {}\n", found.labels[edge.from]);
  }
  for (std::size_t i = 0; i < found.main_paths.size(); ++i) {
    text += fmt::format("main path {}: {} to {}, length {:.2f}\n", i + 1, end_text(found, i, true),
                        end_text(found, i, false), found.main_paths[i].length);
  }
  return text;
}

Json graph_json(const FoundGraph& found) {
  const Graph& graph = found.graph;
  const std::vector<std::size_t> degrees = degrees_of(graph);
  Json nodes = Json::array();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto [x, y] = centre_of(graph, graph.nodes[i]);
    nodes.push_back(node_properties_of(found, i, degrees[i]));
    nodes.back()["centre"] = {x, y};
  }
  Json edges = Json::array();
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    edges.push_back(properties_of(found, i));
    edges.back()["points"] = positions(found.lines[i], pixel_json);
  }
  Json json = {{"file", found.page.file},        {"page", found.page.page},
               {"width", found.width},           {"height", found.height},
               {"spacing", spacing_json(found)}, {"unit", unit_json(found)},
               {"nodes", std::move(nodes)},      {"edges", std::move(edges)}};
  if (!found.main_paths.empty()) json["main_paths"] = main_paths_json(found);
  return json;
}

std::string graph_summary(const FoundGraph& found) {
  const auto number = [](double value) {
    return std::isfinite(value) ? fmt::to_string(value) : std::string();
  };
  std::string text =
      "skeleton-id,node-id-src,node-id-dst,branch-distance,branch-type,image-coord-src-0,"
      "image-coord-src-1,image-coord-dst-0,image-coord-dst-1,coord-src-0,coord-src-1,coord-dst-0,"
      "coord-dst-1,euclidean-distance,tortuosity,smoothed-length,width-mean,width-median,width-min,"
      "width-max";
  text += found.labels.empty() ? "\n" : ",label\n";
  const auto [dx, dy] = found.spacing;
  std::size_t i = 0;
  for (const EdgeSummary& row : summary(found.graph, found.spacing)) {
    const auto& [start, stop] = std::pair(row.start, row.stop);
    const EdgeWidths& width = found.widths[i];
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", row.component,
                    row.from, row.to, row.length, static_cast<int>(row.type), start.y, start.x,
                    stop.y, stop.x, start.y * dy, start.x * dx, stop.y * dy, stop.x * dx, row.chord,
                    number(row.tortuosity), length_of(found.lines[i], found.spacing),
                    number(width.mean), number(width.median), number(width.min), number(width.max));
    ++i;
    text += found.labels.empty() ? "\n" : fmt::format(",{}\n", found.labels[row.from]);
  }
  return text;
}

std::string graph_geojson(const FoundGraph& found, const AffineTransform& transform) {
  const auto position = [&transform](double column, double row) {
    const auto& [a, b, c, d, e, f] = transform;
    const double x = column + 0.5;
    const double y = row + 0.5;
    return Json{a * x + b * y + c, d * x + e * y + f};
  };
  const Graph& graph = found.graph;
  const std::vector<std::size_t> degrees = degrees_of(graph);
  Json features = Json::array();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto [x, y] = centre_of(graph, graph.nodes[i]);
    features.push_back(feature(features.size() + 1, "Point", position(x, y),
                               node_properties_of(found, i, degrees[i])));
  }
  const auto add_line = [&](const std::vector<Pixel>& line, Json properties) {
    Json points = positions(line, [&](Pixel p) { return position(p.x, p.y); });
    if (points.size() == 1) points.push_back(points.front());  // GeoJSON has no shorter lines
    features.push_back(
        feature(features.size() + 1, "LineString", std::move(points), std::move(properties)));
  };
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    Json properties = properties_of(found, i);
    properties["kind"] = "edge";
    add_line(found.lines[i], std::move(properties));
  }
  for (std::size_t i = 0; i < found.main_paths.size(); ++i) {
    Json properties = main_path_properties(found.main_paths[i], i);
    properties["kind"] = "main_path";
    add_line(found.main_lines[i], std::move(properties));
  }
  Json json = {
      {"type", "FeatureCollection"}, {"spacing", spacing_json(found)}, {"unit", unit_json(found)}};
  if (found.place && found.place->epsg != 0) {
    const std::string name = fmt::format("urn:ogc:def:crs:EPSG::{}", found.place->epsg);
    json["crs"] = {{"type", "name"}, {"properties", {{"name", name}}}};
  }
  json["features"] = std::move(features);
  return json.dump() + '\n';
}

Overlay graph_overlay(const FoundGraph& found) {
  constexpr std::array<OverlayColour, kNodeKindNames.size()> colours = {{{0x86, 0x8e, 0x96},
                                                                         {0x2f, 0x9e, 0x44},
                                                                         {0x19, 0x71, 0xc2},
                                                                         {0x9c, 0x36, 0xb5},
                                                                         {0xf0, 0x8c, 0x00}}};
  const Graph& graph = found.graph;
  Overlay overlay;
  overlay.is_faded = true;
  constexpr OverlayColour line = {0xd9, 0x48, 0x0f}, main_line = {0xe0, 0x31, 0xc9};
  std::vector<bool> is_main(graph.edges.size());
  for (const GraphPath& path : found.main_paths) {
    for (const std::uint32_t edge : whole_edges(path)) is_main[edge] = true;
  }
  for (std::size_t i = 0; i < found.lines.size(); ++i) {
    overlay.lines.push_back({found.lines[i], is_main[i] ? main_line : line});
    overlay.lines.back().title =
        fmt::format("edge {}: length {:.2f}", i + 1, length_of(graph.edges[i], found.spacing));
  }
  for (const GraphPath& path : found.main_paths) {
    for (const GraphPath& part : parts_of(path)) {
      overlay.lines.push_back({points_of(graph, part, found.spacing), main_line});
    }
  }
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const GraphNode& node = graph.nodes[i];
    const auto [x, y] = centre_of(graph, node);
    overlay.discs.push_back({x, y, 1.5, colours[static_cast<std::size_t>(node.kind)],
                             fmt::format("node {}: {}", i + 1, kind_of(node))});
  }
  return overlay;
}

}  // namespace thinbench
