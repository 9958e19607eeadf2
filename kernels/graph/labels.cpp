// Graphs of labels. Labels of one colour do not touch, so that the functions for binary images do
// for all of them at once.
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/byte_image.hpp"
#include "core/checks.hpp"
#include "core/label_colours.hpp"
#include "thinbench/graph_labels.hpp"

namespace thinbench {
namespace {

using detail::ByteImage;
using detail::LabelColours;

void append(Graph& to, const Graph& from) {
  const auto nodes = static_cast<std::uint32_t>(to.nodes.size());
  const auto node_pixels = static_cast<std::uint32_t>(to.node_pixels.size());
  const auto edge_pixels = static_cast<std::uint32_t>(to.edge_pixels.size());
  for (GraphNode node : from.nodes) {
    node.first_pixel += node_pixels;
    to.nodes.push_back(node);
  }
  for (GraphEdge edge : from.edges) {
    edge.from += nodes;
    edge.to += nodes;
    edge.first_pixel += edge_pixels;
    to.edges.push_back(edge);
  }
  to.node_pixels.insert(to.node_pixels.end(), from.node_pixels.begin(), from.node_pixels.end());
  to.edge_pixels.insert(to.edge_pixels.end(), from.edge_pixels.begin(), from.edge_pixels.end());
}

template <class T>
std::vector<std::uint32_t> order_by(const std::vector<T>& list, const auto& key) {
  std::vector<std::uint32_t> order(list.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&key](auto a, auto b) { return key(a) < key(b); });
  return order;
}

/// Nodes and edges by label, otherwise in their order.
LabelGraph sorted(const Graph& graph, const ConstLabelView& labels) {
  const auto label_of = [&](std::uint32_t node) {
    const Pixel first = graph.node_pixels[graph.nodes[node].first_pixel];
    return labels.row(first.y)[first.x];
  };
  LabelGraph result;
  std::vector<std::uint32_t> numbers(graph.nodes.size());
  Graph& to = result.graph;
  for (const std::uint32_t i : order_by(graph.nodes, label_of)) {
    const auto pixels = graph.pixels_of(graph.nodes[i]);
    numbers[i] = static_cast<std::uint32_t>(to.nodes.size());
    to.nodes.push_back(graph.nodes[i]);
    to.nodes.back().first_pixel = static_cast<std::uint32_t>(to.node_pixels.size());
    to.node_pixels.insert(to.node_pixels.end(), pixels.begin(), pixels.end());
    result.labels.push_back(label_of(i));
  }
  const auto label_of_edge = [&](std::uint32_t edge) { return label_of(graph.edges[edge].from); };
  for (const std::uint32_t i : order_by(graph.edges, label_of_edge)) {
    GraphEdge edge = graph.edges[i];
    const auto pixels = graph.pixels_of(edge);
    edge.from = numbers[edge.from];
    edge.to = numbers[edge.to];
    edge.first_pixel = static_cast<std::uint32_t>(to.edge_pixels.size());
    to.edges.push_back(edge);
    to.edge_pixels.insert(to.edge_pixels.end(), pixels.begin(), pixels.end());
  }
  return result;
}

}  // namespace

LabelGraph graph_of_labels(ConstLabelView skeletons, const Execution& execution) {
  detail::check(detail::memory_of("skeletons", skeletons));
  detail::require_label_size(skeletons.width, skeletons.height);
  Graph all;
  LabelColours(skeletons).for_each(
      [&](const ConstImageView& mask) { append(all, skeleton_graph(mask, execution)); });
  return sorted(all, skeletons);
}

void distances_of_labels(ConstLabelView labels, View<double> distances, const Spacing& spacing,
                         const Execution& execution) {
  detail::check(detail::memory_of("labels", labels), detail::memory_of("distances", distances),
                detail::InPlace::rejected);
  detail::require_label_size(labels.width, labels.height);
  LabelColours colours(labels);
  if (colours.count() == 1) {
    colours.for_each([&](const ConstImageView& mask) {
      thinbench::distances(mask, distances, spacing, execution);
    });
    return;
  }
  const Index width = labels.width;
  std::vector<double> memory(static_cast<std::size_t>(width * labels.height));
  const View<double> of_colour(memory.data(), width, labels.height);
  bool is_first = true;
  colours.for_each([&](const ConstImageView& mask) {
    thinbench::distances(mask, of_colour, spacing, execution);
    for (Index y = 0; y < labels.height; ++y) {
      const double* from = of_colour.row(y);
      double* to = distances.row(y);
      for (Index x = 0; x < width; ++x) to[x] = is_first ? from[x] : std::max(to[x], from[x]);
    }
    is_first = false;
  });
}

LabelGraph prune_labels(ConstLabelView skeletons, LabelView destination, const Pruning& pruning,
                        const Execution& execution) {
  detail::check(detail::memory_of("skeletons", skeletons),
                detail::memory_of("destination", destination), detail::InPlace::allowed);
  detail::require_label_size(skeletons.width, skeletons.height);
  ByteImage kept(skeletons.width, skeletons.height);
  std::vector<std::uint8_t> is_kept(static_cast<std::size_t>(kept.width() * kept.height()));
  Graph all;
  LabelColours(skeletons).for_each([&](const ConstImageView& mask) {
    append(all, prune(mask, kept.view(), pruning, execution));
    for (Index y = 0; y < kept.height(); ++y) {
      const std::uint8_t* from = kept.view().row(y);
      std::uint8_t* to = is_kept.data() + y * kept.width();
      for (Index x = 0; x < kept.width(); ++x) to[x] |= from[x];
    }
  });
  LabelGraph result = sorted(all, skeletons);
  for (Index y = 0; y < kept.height(); ++y) {
    const std::uint8_t* at = is_kept.data() + y * kept.width();
    for (Index x = 0; x < kept.width(); ++x) {
      destination.row(y)[x] = at[x] != 0 ? skeletons.row(y)[x] : 0;
    }
  }
  return result;
}

}  // namespace thinbench
