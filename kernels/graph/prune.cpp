#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "graph/state.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

using detail::require;

void check_distances(const ConstLabelView& squared_distances) {
  const auto [data, width, height, stride] = squared_distances;
  require(data != nullptr || width == 0 || height == 0, "squared_distances has no data");
  require(stride >= width, "squared_distances has a stride of " + std::to_string(stride) +
                               ", below its width of " + std::to_string(width));
}

void check(const Pruning& pruning, const ConstImageView& skeleton) {
  const auto check_limit = [](const char* name, double value) {
    require(value >= 0 && std::isfinite(value),
            std::string(name) + ": expected a number of at least 0, got " + std::to_string(value));
  };
  check_limit("min_length", pruning.min_length);
  check_limit("min_widths", pruning.min_widths);
  const ConstLabelView& distances = pruning.squared_distances;
  require(
      pruning.min_widths == 0 || (distances.data != nullptr && distances.width == skeleton.width &&
                                  distances.height == skeleton.height),
      "min_widths: expected squared_distances of size " +
          detail::size_text(skeleton.width, skeleton.height));
  if (pruning.min_widths != 0) check_distances(distances);
}

double width_at(const ConstLabelView& squared_distances, Pixel p) {
  const std::int32_t square = squared_distances.row(p.y)[p.x];
  return square == kNoBackground ? std::numeric_limits<double>::infinity() : 2 * std::sqrt(square);
}

/// Removes branches from an image, round after round.
class Pruner {
 public:
  Pruner(const ImageView& image, const Pruning& pruning, detail::GraphState& state)
      : image_(image), pruning_(pruning), state_(state) {}

  Graph run() {
    for (;;) {
      state_.load(image_);
      const Graph& graph = state_.compute();
      if (!remove_from(graph)) return graph;
    }
  }

 private:
  bool remove_from(const Graph& graph) {
    shortest_.assign(graph.nodes.size(), nullptr);
    for (const GraphEdge& edge : graph.edges) note(graph, edge);
    bool removed = false;
    for (const GraphEdge* edge : shortest_) {
      if (edge == nullptr) continue;
      remove(graph, *edge);
      removed = true;
    }
    if (pruning_.removes_components) removed = remove_points(graph) || removed;
    return removed;
  }

  /// Remembers a short branch at its junction, a line that is a component at its first end.
  void note(const Graph& graph, const GraphEdge& edge) {
    const NodeKind from = graph.nodes[edge.from].kind;
    const NodeKind to = graph.nodes[edge.to].kind;
    const double length = length_of(edge);
    if (from == NodeKind::end && to == NodeKind::end) {
      if (pruning_.removes_components && length < pruning_.min_length) shortest_[edge.from] = &edge;
      return;
    }
    if (from != NodeKind::end && to != NodeKind::end) return;
    const bool ends_at_from = from == NodeKind::end;
    if (length >= limit_at(ends_at_from ? edge.stop : edge.start)) return;
    const GraphEdge*& shortest = shortest_[ends_at_from ? edge.to : edge.from];
    if (shortest == nullptr || length < length_of(*shortest)) shortest = &edge;
  }

  [[nodiscard]] double limit_at(Pixel junction) const {
    if (pruning_.min_widths == 0) return pruning_.min_length;
    const double width = width_at(pruning_.squared_distances, junction);
    return std::max(pruning_.min_length, pruning_.min_widths * width);
  }

  void remove(const Graph& graph, const GraphEdge& edge) {
    for (const Pixel p : graph.pixels_of(edge)) clear(p);
    if (graph.nodes[edge.from].kind == NodeKind::end) clear(edge.start);
    if (graph.nodes[edge.to].kind == NodeKind::end) clear(edge.stop);
  }

  bool remove_points(const Graph& graph) {
    bool removed = false;
    for (const GraphNode& node : graph.nodes) {
      if (node.kind != NodeKind::isolated || pruning_.min_length == 0) continue;
      clear(graph.pixels_of(node).front());
      removed = true;
    }
    return removed;
  }

  void clear(Pixel p) { image_.row(p.y)[p.x] = 0; }

  ImageView image_;
  const Pruning& pruning_;
  detail::GraphState& state_;
  std::vector<const GraphEdge*> shortest_;  // of every node
};

void copy_binary(const ConstImageView& source, const ImageView& destination) {
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      destination.row(y)[x] = source.row(y)[x] == 0 ? 0 : 255;
    }
  }
}

}  // namespace

Graph prune(ConstImageView skeleton, ImageView destination, const Pruning& pruning,
            const Execution& execution) {
  detail::check_views(skeleton, destination, detail::InPlace::allowed);
  check(pruning, skeleton);
  const auto state = detail::make_best_state(detail::graph_operation(), skeleton.width,
                                             skeleton.height, {}, execution);
  if (skeleton.width == 0 || skeleton.height == 0) return {};  // such rows need no memory
  detail::ByteImage image(skeleton.width, skeleton.height);
  copy_binary(skeleton, image.view());
  Graph graph = Pruner(image.view(), pruning, *state).run();
  copy_binary(image.view(), destination);
  return graph;
}

std::vector<EdgeWidths> edge_widths(const Graph& graph, ConstLabelView squared_distances) {
  check_distances(squared_distances);
  const auto width_of = [&](Pixel p) {
    require(p.x < squared_distances.width && p.y < squared_distances.height,
            "squared_distances: smaller than the image of the graph");
    return width_at(squared_distances, p);
  };
  std::vector<EdgeWidths> widths;
  for (const GraphEdge& edge : graph.edges) {
    const double first = width_of(edge.start);
    const double last = width_of(edge.stop);
    EdgeWidths found = {first + last, std::min(first, last), std::max(first, last)};
    for (const Pixel p : graph.pixels_of(edge)) {
      const double width = width_of(p);
      found.mean += width;
      found.least = std::min(found.least, width);
      found.greatest = std::max(found.greatest, width);
    }
    found.mean = std::clamp(found.mean / (edge.pixel_count + 2.0), found.least, found.greatest);
    widths.push_back(found);
  }
  return widths;
}

}  // namespace thinbench
