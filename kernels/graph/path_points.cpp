// Main paths between the pixels of graphs, and the pixels along paths.
#include <algorithm>
#include <string>

#include "core/checks.hpp"
#include "graph/main_paths.hpp"

namespace thinbench {
namespace {

using Pixels = std::vector<Pixel>;

/// Along the pixels of a line, from its start to each.
std::vector<double> positions_of(Pixel start, std::span<const Pixel> line, const Spacing& spacing) {
  std::vector<double> positions;
  positions.reserve(line.size());
  Steps steps;
  Pixel previous = start;
  for (const Pixel p : line) {
    const bool is_diagonal = p.x != previous.x && p.y != previous.y;
    ++(is_diagonal ? steps.diagonal : p.x != previous.x ? steps.horizontal : steps.vertical);
    positions.push_back(length_of(steps, spacing));
    previous = p;
  }
  return positions;
}

bool are_below(const std::vector<std::uint32_t>& numbers, std::size_t count) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [=](std::uint32_t number) { return number < count; });
}

/// Whether its numbers are those of nodes, edges and pixels of the graph.
bool is_path_of(const Graph& graph, const GraphPath& path) {
  const auto& [length, nodes, edges, first, last] = path;
  const std::size_t partial = std::size_t{first.has_value()} + std::size_t{last.has_value()};
  if (!are_below(nodes, graph.nodes.size()) || !are_below(edges, graph.edges.size())) return false;
  if (partial > 0 && edges.empty()) return false;
  if (first && *first >= graph.edges[edges.front()].pixel_count) return false;
  if (last && *last >= graph.edges[edges.back()].pixel_count) return false;
  if (nodes.empty()) return partial == 2 && edges.size() == 1 && *first <= *last;
  return edges.size() >= partial && edges.size() - partial <= nodes.size();
}

/// From one of its nodes to a pixel of an edge. Of a loop it is the shorter part, of equal ones the
/// first.
Pixels part_of(const Graph& graph, const GraphEdge& edge, std::uint32_t node, std::uint32_t point,
               const Spacing& spacing) {
  Pixels points = points_of(graph, edge);
  const auto line = graph.pixels_of(edge).first(point + std::size_t{1});
  const double position = positions_of(edge.start, line, spacing).back();
  const bool is_first =
      edge.from == edge.to ? position <= length_of(edge, spacing) - position : edge.from == node;
  if (!is_first) std::reverse(points.begin(), points.end());
  points.resize(is_first ? point + std::size_t{2} : points.size() - point - 1);
  return points;
}

/// Along a path with nodes and edges; where edges meet in one pixel, it is there twice.
Pixels pieces_of(const Graph& graph, const GraphPath& path, const Spacing& spacing) {
  const auto edge_at = [&](std::size_t i) -> const GraphEdge& {
    return graph.edges[path.edges[i]];
  };
  const std::size_t begin = path.first_point ? 1 : 0;
  const std::size_t end = path.edges.size() - (path.last_point ? 1 : 0);
  Pixels points;
  if (path.first_point) {
    points = part_of(graph, edge_at(0), path.nodes.front(), *path.first_point, spacing);
    std::reverse(points.begin(), points.end());
  }
  const auto append = [&](const Pixels& more) {
    points.insert(points.end(), more.begin(), more.end());
  };
  for (std::size_t i = begin; i < end; ++i) {
    Pixels line = points_of(graph, edge_at(i));
    if (edge_at(i).from != path.nodes[i - begin]) std::reverse(line.begin(), line.end());
    append(line);
  }
  if (path.last_point) {
    append(part_of(graph, edge_at(end), path.nodes.back(), *path.last_point, spacing));
  }
  return points;
}

}  // namespace

namespace detail {

std::vector<GraphPath> main_paths(std::uint32_t nodes, std::span<const GraphEdge> edges,
                                  std::span<const Pixel> pixels, const Spacing& spacing) {
  require_spacing(spacing);
  std::vector<Link> links;
  links.reserve(edges.size());
  for (const GraphEdge& edge : edges) {
    require(std::uint64_t{edge.first_pixel} + edge.pixel_count <= pixels.size(), [&] {
      return "edge " + std::to_string(links.size()) + ": expected pixels below " +
             std::to_string(pixels.size()) + ", got " + std::to_string(edge.pixel_count) +
             " from " + std::to_string(edge.first_pixel);
    });
    links.push_back({edge.from, edge.to, length_of(edge, spacing)});
  }
  return main_paths(nodes, links, [&](std::uint32_t number) {
    const GraphEdge& edge = edges[number];
    return positions_of(edge.start, pixels.subspan(edge.first_pixel, edge.pixel_count), spacing);
  });
}

}  // namespace detail

std::vector<GraphPath> main_paths(const Graph& graph, const Spacing& spacing) {
  return detail::main_paths(static_cast<std::uint32_t>(graph.nodes.size()), graph.edges,
                            graph.edge_pixels, spacing);
}

std::vector<Pixel> points_of(const Graph& graph, const GraphPath& path, const Spacing& spacing) {
  detail::require_spacing(spacing);
  detail::require(is_path_of(graph, path), "path: expected one of the graph");
  if (path.nodes.empty()) {
    const auto line = graph.pixels_of(graph.edges[path.edges.front()]);
    const auto part = line.subspan(*path.first_point, *path.last_point - *path.first_point + 1);
    return {part.begin(), part.end()};
  }
  if (path.edges.empty()) return {graph.pixels_of(graph.nodes[path.nodes.front()]).front()};
  Pixels points = pieces_of(graph, path, spacing);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace thinbench
