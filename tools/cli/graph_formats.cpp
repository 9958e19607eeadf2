#include "cli/graph_formats.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/text.hpp"

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

double chord_of(const GraphEdge& edge) {
  return std::hypot(edge.stop.x - edge.start.x, edge.stop.y - edge.start.y);
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

std::string number_of(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// "3 nodes (2 ends, 1 junction)".
std::string nodes_text(const Graph& graph) {
  std::string text = number_of(graph.nodes.size(), "node");
  const char* before = " (";
  for (std::size_t kind = 0; kind < kNodeKindNames.size(); ++kind) {
    const auto count = static_cast<std::size_t>(
        std::ranges::count(graph.nodes, static_cast<NodeKind>(kind), &GraphNode::kind));
    if (count == 0) continue;
    const bool is_noun = static_cast<NodeKind>(kind) != NodeKind::isolated;
    const std::string name(kNodeKindNames[kind]);
    text += before + (is_noun ? number_of(count, name.c_str()) : fmt::format("{} {}", count, name));
    before = ", ";
  }
  return graph.nodes.empty() ? text : text + ")";
}

Json properties_of(const FoundGraph& found, std::size_t i) {
  const GraphEdge& edge = found.graph.edges[i];
  const EdgeWidths& width = found.widths[i];
  return {{"id", i + 1},
          {"from", edge.from + 1},
          {"to", edge.to + 1},
          {"pixels", edge.pixel_count},
          {"length", length_of(edge)},
          {"chord", chord_of(edge)},
          {"width_mean", width.mean},
          {"width_min", width.least},
          {"width_max", width.greatest}};
}

Json properties_of(const Graph& graph, std::size_t i, std::size_t degree) {
  return {{"id", i + 1}, {"kind", kind_of(graph.nodes[i])}, {"degree", degree}};
}

template <class PositionOf>
Json positions(const std::vector<Pixel>& line, const PositionOf& position_of) {
  Json list = Json::array();
  for (const Pixel p : line) list.push_back(position_of(p));
  return list;
}

Json feature(const char* type, Json coordinates, Json properties) {
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}},
          {"properties", std::move(properties)}};
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::string graph_list(const FoundGraph& found) {
  const Graph& graph = found.graph;
  std::string text = nodes_text(graph) + ", " + number_of(graph.edges.size(), "edge") + '\n';
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto [x, y] = centre_of(graph, graph.nodes[i]);
    text += fmt::format("node {}: {} at ({:.2f}, {:.2f})\n", i + 1, kind_of(graph.nodes[i]), x, y);
  }
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const GraphEdge& edge = graph.edges[i];
    const EdgeWidths& width = found.widths[i];
    text += fmt::format("edge {}: node {} to {}, length {:.2f}, width {:.2f} ({:.2f} to {:.2f})\n",
                        i + 1, edge.from + 1, edge.to + 1, length_of(edge), width.mean, width.least,
                        width.greatest);
  }
  return text;
}

std::string graph_json(const FoundGraph& found) {
  const Graph& graph = found.graph;
  const std::vector<std::size_t> degrees = degrees_of(graph);
  Json nodes = Json::array();
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto [x, y] = centre_of(graph, graph.nodes[i]);
    nodes.push_back(properties_of(graph, i, degrees[i]));
    nodes.back()["centre"] = {x, y};
  }
  Json edges = Json::array();
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    edges.push_back(properties_of(found, i));
    edges.back()["points"] = positions(found.lines[i], [](Pixel p) { return Json{p.x, p.y}; });
  }
  const Json json = {{"file", found.file},
                     {"width", found.width},
                     {"height", found.height},
                     {"nodes", nodes},
                     {"edges", edges}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string graph_csv(const FoundGraph& found) {
  const Graph& graph = found.graph;
  const auto cell = [](double width) { return std::isfinite(width) ? fmt::to_string(width) : ""; };
  std::string text =
      "file,image_width,image_height,id,from,to,from_kind,to_kind,from_x,from_y,to_x,to_y,pixels,"
      "length,chord,width_mean,"
      "width_min,width_max\n";
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const GraphEdge& edge = graph.edges[i];
    const EdgeWidths& width = found.widths[i];
    fmt::format_to(std::back_inserter(text),
                   "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(found.file),
                   found.width, found.height, i + 1, edge.from + 1, edge.to + 1,
                   kind_of(graph.nodes[edge.from]), kind_of(graph.nodes[edge.to]), edge.start.x,
                   edge.start.y, edge.stop.x, edge.stop.y, edge.pixel_count, length_of(edge),
                   chord_of(edge), cell(width.mean), cell(width.least), cell(width.greatest));
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
    features.push_back(feature("Point", position(x, y), properties_of(graph, i, degrees[i])));
  }
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    features.push_back(feature(
        "LineString", positions(found.lines[i], [&](Pixel p) { return position(p.x, p.y); }),
        properties_of(found, i)));
  }
  return Json{{"type", "FeatureCollection"}, {"features", features}}.dump() + '\n';
}

std::string graph_svg(const FoundGraph& found, const std::string& png) {
  constexpr Index small_side = 800;
  const Index scale = std::max<Index>(1, small_side / std::max(found.width, found.height));
  std::string text = fmt::format(
      R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" viewBox="0 0 {} {}">
<image width="{}" height="{}" style="image-rendering: pixelated; opacity: 0.5" href="data:image/png;base64,{}"/>
<g fill="none" stroke="#d9480f" stroke-linejoin="round" transform="translate(0.5 0.5)">
)svg",
      scale * found.width, scale * found.height, found.width, found.height, found.width,
      found.height, base64(png));
  for (std::size_t i = 0; i < found.lines.size(); ++i) {
    text += "<polyline points=\"";
    for (const Pixel p : found.lines[i])
      fmt::format_to(std::back_inserter(text), "{},{} ", p.x, p.y);
    fmt::format_to(std::back_inserter(text),
                   "\"><title>edge {}: length {:.2f}</title></polyline>\n", i + 1,
                   length_of(found.graph.edges[i]));
  }
  text += "</g>\n<g transform=\"translate(0.5 0.5)\">\n";
  constexpr std::array<std::string_view, 4> colours = {"#868e96", "#2f9e44", "#1971c2", "#9c36b5"};
  for (std::size_t i = 0; i < found.graph.nodes.size(); ++i) {
    const GraphNode& node = found.graph.nodes[i];
    const auto [x, y] = centre_of(found.graph, node);
    fmt::format_to(std::back_inserter(text),
                   "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"1.5\" fill=\"{}\"><title>node {}: "
                   "{}</title></circle>\n",
                   x, y, colours[static_cast<std::size_t>(node.kind)], i + 1, kind_of(node));
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace thinbench
