#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "graph.hpp"

namespace thinbench::reference {
namespace {

double length_of_line(const GraphEdge& edge, const Spacing& spacing) {
  const auto [horizontal, vertical, diagonal] = edge.steps;
  return horizontal * spacing.x + vertical * spacing.y +
         diagonal * std::sqrt(spacing.x * spacing.x + spacing.y * spacing.y);
}

/// Below which a branch at this pixel of a junction is short.
double limit(const Pruning& pruning, Pixel junction) {
  if (pruning.min_widths == 0) return pruning.min_length;
  const View<const double>& distances = pruning.distances;
  const double width = 2 * distances.data[distances.stride * junction.y + junction.x];
  return std::max(pruning.min_length, pruning.min_widths * width);
}

/// The pixels of a line, and its ends where they are ends of the skeleton.
std::vector<Pixel> pixels_to_remove(const Graph& graph, const GraphEdge& edge) {
  const auto line = graph.pixels_of(edge);
  std::vector<Pixel> pixels(line.begin(), line.end());
  if (graph.nodes[edge.from].kind == NodeKind::end) pixels.push_back(edge.start);
  if (graph.nodes[edge.to].kind == NodeKind::end) pixels.push_back(edge.stop);
  return pixels;
}

std::vector<Pixel> pixels_of_a_round(const Graph& graph, const Pruning& pruning) {
  std::vector<Pixel> pixels;
  const auto take = [&](const std::vector<Pixel>& more) {
    pixels.insert(pixels.end(), more.begin(), more.end());
  };
  // By junction and length; of equal lengths, the first edge remains.
  std::map<std::uint32_t, std::map<double, const GraphEdge*>> branches;
  for (const GraphEdge& edge : graph.edges) {
    const bool starts = graph.nodes[edge.from].kind == NodeKind::end;
    const bool stops = graph.nodes[edge.to].kind == NodeKind::end;
    const double length = length_of_line(edge, pruning.spacing);
    if (starts && stops) {
      if (pruning.removes_components && length < pruning.min_length) {
        take(pixels_to_remove(graph, edge));
      }
    } else if (starts && length < limit(pruning, edge.stop)) {
      branches[edge.to].emplace(length, &edge);
    } else if (stops && length < limit(pruning, edge.start)) {
      branches[edge.from].emplace(length, &edge);
    }
  }
  for (const auto& one : branches) take(pixels_to_remove(graph, *one.second.begin()->second));
  for (const GraphNode& node : graph.nodes) {
    const bool is_short = pruning.removes_components && pruning.min_length > 0;
    if (node.kind == NodeKind::isolated && is_short) take({graph.pixels_of(node).front()});
  }
  return pixels;
}

}  // namespace

void prune(ConstImageView skeleton, ImageView destination, const Pruning& pruning) {
  for (Index y = 0; y < skeleton.height; ++y) {
    for (Index x = 0; x < skeleton.width; ++x) {
      destination.row(y)[x] = skeleton.row(y)[x] == 0 ? 0 : 255;
    }
  }
  for (;;) {
    const auto pixels = pixels_of_a_round(reference::skeleton_graph(destination), pruning);
    if (pixels.empty()) return;
    for (const Pixel p : pixels) destination.row(p.y)[p.x] = 0;
  }
}

}  // namespace thinbench::reference
