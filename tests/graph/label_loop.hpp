// What is done for all labels of an image at once, done for each label alone.
#pragma once

#include <set>

#include "graph.hpp"
#include "support/made_image.hpp"
#include "thinbench/graph_labels.hpp"

namespace thinbench {

/// `body(label, mask)` for every label but 0, in ascending order.
template <class Body>
void for_each_label(const LabelImage& image, const Body& body) {
  std::set<std::int32_t> labels(image.labels.begin(), image.labels.end());
  labels.erase(0);
  for (const std::int32_t label : labels) {
    body(label, image_by(image.width, image.height, [&](Index x, Index y) {
           return image.view().row(y)[x] == label ? 255 : 0;
         }));
  }
}

inline void append(LabelGraph& to, std::int32_t label, const Graph& graph) {
  const auto size_of = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  for (GraphEdge edge : graph.edges) {
    edge.from += size_of(to.graph.nodes);
    edge.to += size_of(to.graph.nodes);
    edge.first_pixel += size_of(to.graph.edge_pixels);
    to.graph.edges.push_back(edge);
  }
  for (GraphNode node : graph.nodes) {
    node.first_pixel += size_of(to.graph.node_pixels);
    to.labels.push_back(label);
    to.graph.nodes.push_back(node);
  }
  to.graph.edge_pixels.insert(to.graph.edge_pixels.end(), graph.edge_pixels.begin(),
                              graph.edge_pixels.end());
  to.graph.node_pixels.insert(to.graph.node_pixels.end(), graph.node_pixels.begin(),
                              graph.node_pixels.end());
}

/// By the reference.
inline LabelGraph graph_of_each_label(const LabelImage& image) {
  LabelGraph all;
  for_each_label(image, [&](std::int32_t label, const ByteImage& mask) {
    append(all, label, reference::skeleton_graph(mask.view()));
  });
  return all;
}

}  // namespace thinbench
