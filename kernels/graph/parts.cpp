#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "core/checks.hpp"
#include "thinbench/graph_parts.hpp"
#include "thinbench/graph_paths.hpp"

namespace thinbench {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::uint32_t size_of(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

Numbers all_of(std::uint32_t count) {
  Numbers numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

void append_node(Graph& to, NodeKind kind, std::span<const Pixel> pixels) {
  to.nodes.push_back({kind, size_of(to.node_pixels), size_of(pixels)});
  to.node_pixels.insert(to.node_pixels.end(), pixels.begin(), pixels.end());
}

void append_edge(Graph& to, GraphEdge edge, std::span<const Pixel> pixels) {
  edge.first_pixel = size_of(to.edge_pixels);
  edge.pixel_count = size_of(pixels);
  to.edges.push_back(edge);
  to.edge_pixels.insert(to.edge_pixels.end(), pixels.begin(), pixels.end());
}

/// Of these nodes, in ascending order, and of these edges between them.
Graph chosen(const Graph& graph, const Numbers& nodes, std::span<const std::uint32_t> edges) {
  Graph result;
  Numbers numbers(graph.nodes.size());
  for (const std::uint32_t node : nodes) {
    numbers[node] = size_of(result.nodes);
    append_node(result, graph.nodes[node].kind, graph.pixels_of(graph.nodes[node]));
  }
  for (const std::uint32_t number : edges) {
    GraphEdge edge = graph.edges[number];
    const std::span<const Pixel> pixels = graph.pixels_of(edge);
    edge.from = numbers[edge.from];
    edge.to = numbers[edge.to];
    append_edge(result, edge, pixels);
  }
  return result;
}

struct LinePixel {
  std::uint32_t edge;
  std::uint32_t position;  // in the pixels of the line
};

/// Where the lines of the graph have a pixel.
std::optional<LinePixel> find_on_lines(const Graph& graph, Pixel pixel) {
  for (std::uint32_t edge = 0; edge < graph.edges.size(); ++edge) {
    const auto pixels = graph.pixels_of(graph.edges[edge]);
    const auto found = std::find(pixels.begin(), pixels.end(), pixel);
    if (found == pixels.end()) continue;
    return LinePixel{edge, static_cast<std::uint32_t>(found - pixels.begin())};
  }
  return std::nullopt;
}

Steps steps_of(std::span<const Pixel> points) {
  Steps steps;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool moves_x = points[i].x != points[i - 1].x;
    const bool moves_y = points[i].y != points[i - 1].y;
    ++(moves_x && moves_y ? steps.diagonal : moves_x ? steps.horizontal : steps.vertical);
  }
  return steps;
}

/// An edge along these points, of which the last is the pixel of a new node.
void append_piece(Graph& to, std::uint32_t from, std::uint32_t node,
                  std::span<const Pixel> points) {
  append_edge(to, {from, node, points.front(), points.back(), 0, 0, steps_of(points)},
              points.subspan(1, points.size() - 2));
}

Graph split_line(const Graph& graph, const LinePixel& at) {
  const GraphEdge& split = graph.edges[at.edge];
  std::vector<Pixel> points = points_of(graph, split);
  const std::size_t middle = at.position + 1;
  Graph result = {graph.nodes, {}, graph.node_pixels, {}};
  const std::uint32_t node = size_of(graph.nodes);
  append_node(result, NodeKind::given, {&points[middle], 1});
  for (const GraphEdge& edge : graph.edges) {
    if (&edge != &split) {
      append_edge(result, edge, graph.pixels_of(edge));
      continue;
    }
    append_piece(result, split.from, node, std::span(points).first(middle + 1));
    std::reverse(points.begin(), points.end());
    append_piece(result, split.to, node, std::span(points).first(points.size() - middle));
  }
  return result;
}

double distance_between(Pixel a, Pixel b, const Spacing& spacing) {
  return std::hypot((static_cast<double>(b.x) - a.x) * spacing.x,
                    (static_cast<double>(b.y) - a.y) * spacing.y);
}

/// The number of the edge, from 1, of each node that has only one.
Numbers only_edges(const Graph& graph) {
  Numbers edges(graph.nodes.size());
  std::vector<bool> has_others(graph.nodes.size());
  for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
    for (const std::uint32_t node : {graph.edges[i].from, graph.edges[i].to}) {
      if (edges[node] != 0 && edges[node] != i + 1) has_others[node] = true;
      edges[node] = has_others[node] ? 0 : i + 1;
    }
  }
  return edges;
}

EdgeType type_of(const Graph& graph, const GraphEdge& edge) {
  const NodeKind from = graph.nodes[edge.from].kind;
  if (from == NodeKind::cycle) return EdgeType::cycle;
  const int ends = int{from == NodeKind::end} + int{graph.nodes[edge.to].kind == NodeKind::end};
  return static_cast<EdgeType>(2 - ends);
}

}  // namespace

Graph subgraph(const Graph& graph, std::span<const std::uint32_t> edges) {
  std::vector<bool> is_used(graph.nodes.size());
  for (const std::uint32_t edge : edges) {
    detail::require(edge < graph.edges.size(), [&] {
      return "edges: expected numbers below " + std::to_string(graph.edges.size()) + ", got " +
             std::to_string(edge);
    });
    is_used[graph.edges[edge].from] = is_used[graph.edges[edge].to] = true;
  }
  Numbers nodes = all_of(size_of(graph.nodes));
  std::erase_if(nodes, [&](std::uint32_t node) { return !is_used[node]; });
  return chosen(graph, nodes, edges);
}

Graph split_graph(const Graph& graph, std::span<const Pixel> pixels) {
  Graph result = graph;
  for (const Pixel pixel : pixels) {
    const auto& nodes = result.node_pixels;
    if (std::find(nodes.begin(), nodes.end(), pixel) != nodes.end()) continue;
    const auto at = find_on_lines(result, pixel);
    detail::require(at.has_value(), "nodes: expected pixels of the skeleton, got row " +
                                        std::to_string(pixel.y) + ", column " +
                                        std::to_string(pixel.x));
    result = split_line(result, *at);
  }
  return result;
}

Graph open_cycles(const Graph& graph, double max_length, const Spacing& spacing) {
  detail::require(max_length >= 0, "max_length: expected a number of at least 0, got " +
                                       detail::number_text(max_length));
  Numbers edges = all_of(size_of(graph.edges));
  const std::uint32_t removed = std::numeric_limits<std::uint32_t>::max();
  for (const GraphPath& cycle : cycles(size_of(graph.nodes), links_of(graph, spacing))) {
    if (cycle.length <= max_length) edges[cycle.edges.back()] = removed;
  }
  std::erase(edges, removed);
  return chosen(graph, all_of(size_of(graph.nodes)), edges);
}

GraphPlace nearest_place(const Graph& graph, double x, double y, const Spacing& spacing) {
  detail::require_spacing(spacing);
  detail::require(
      std::isfinite(x) && std::isfinite(y),
      "expected a finite point, got " + detail::number_text(x) + ", " + detail::number_text(y));
  detail::require(!graph.edges.empty(), "expected a graph with edges, got none");
  GraphPlace nearest = {0, graph.edges.front().start, std::numeric_limits<double>::infinity()};
  for (std::uint32_t edge = 0; edge < graph.edges.size(); ++edge) {
    for (const Pixel p : points_of(graph, graph.edges[edge])) {
      const double distance = std::hypot((p.x - x) * spacing.x, (p.y - y) * spacing.y);
      if (distance < nearest.distance) nearest = {edge, p, distance};
    }
  }
  return nearest;
}

void edge_labels(const Graph& graph, LabelView destination) {
  detail::check(detail::memory_of("destination", destination));
  const Index width = destination.width;
  const Index height = destination.height;
  const auto is_inside = [=](Pixel p) {
    return p.x >= 0 && p.y >= 0 && p.x < width && p.y < height;
  };
  for (const auto* pixels : {&graph.node_pixels, &graph.edge_pixels}) {
    detail::require(std::all_of(pixels->begin(), pixels->end(), is_inside),
                    "destination: smaller than the image of the graph");
  }
  for (Index y = 0; y < height; ++y) std::fill_n(destination.row(y), width, 0);
  const auto write = [&](std::span<const Pixel> pixels, std::uint32_t label) {
    for (const Pixel p : pixels) destination.row(p.y)[p.x] = static_cast<std::int32_t>(label);
  };
  const Numbers of_nodes = only_edges(graph);
  for (std::uint32_t node = 0; node < graph.nodes.size(); ++node) {
    write(graph.pixels_of(graph.nodes[node]), of_nodes[node]);
  }
  for (std::uint32_t edge = 0; edge < graph.edges.size(); ++edge) {
    write(graph.pixels_of(graph.edges[edge]), edge + 1);
  }
}

std::vector<EdgeSummary> summary(const Graph& graph, const Spacing& spacing) {
  const auto components = components_of(size_of(graph.nodes), links_of(graph, spacing));
  std::vector<EdgeSummary> rows;
  rows.reserve(graph.edges.size());
  for (const GraphEdge& edge : graph.edges) {
    const double length = length_of(edge, spacing);
    const double chord = distance_between(edge.start, edge.stop, spacing);
    rows.push_back({components[edge.from], edge.from, edge.to, type_of(graph, edge), edge.start,
                    edge.stop, length, chord,
                    chord > 0 ? length / chord : std::numeric_limits<double>::quiet_NaN()});
  }
  return rows;
}

}  // namespace thinbench
