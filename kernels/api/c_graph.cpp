// The C interface of graphs.
#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "api/c_arguments.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/graph_parts.hpp"

static_assert(offsetof(thinbench_graph_node, pixel_count) ==
              offsetof(thinbench::GraphNode, pixel_count));
static_assert(offsetof(thinbench_graph_edge, horizontal_steps) ==
              offsetof(thinbench::GraphEdge, steps));
static_assert(sizeof(thinbench_widths) == sizeof(thinbench::EdgeWidths));

struct thinbench_graph : thinbench::Graph {
  std::vector<std::int32_t> labels;  // of the nodes; empty without labels
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

thinbench_graph graph_of(Graph graph) {
  return {{std::move(graph)}, {}};
}

thinbench_graph graph_of(LabelGraph found) {
  return {{std::move(found.graph)}, std::move(found.labels)};
}

Pruning pruning_of(const thinbench_pruning* pruning) {
  const auto given = known(pruning, thinbench_pruning THINBENCH_PRUNING_INIT, "pruning");
  Pruning result = {.min_length = given.min_length, .min_widths = given.min_widths};
  if (given.distances != nullptr) result.distances = reals_of(given.distances, "distances");
  result.removes_components = given.removes_components != 0;
  result.spacing = spacing_of(given.spacing);
  return result;
}

/// Sets a handle that the caller may not want to what `make` returns.
template <class Make>
thinbench_status give_if_wanted(thinbench_graph** graph, const Make& make) noexcept {
  if (graph != nullptr) return give(graph, "graph", make);
  return guarded([&] { make(); });
}

}  // namespace

thinbench_status thinbench_classify_pixels(const thinbench_image* image,
                                           const thinbench_image* classes,
                                           const thinbench_image* degrees,
                                           const thinbench_execution* execution) {
  return guarded([&] {
    const ConstImageView source = image_of(image, "image");
    const auto view = [&](const thinbench_image* result, const char* name) {
      if (result == nullptr) return ImageView();
      const ImageView to = written(result, name).view;
      check(memory_of("image", source), memory_of(name, to), InPlace::rejected);
      return to;
    };
    classify_pixels(source, view(classes, "classes"), view(degrees, "degrees"),
                    execution_of(execution));
  });
}

thinbench_status thinbench_full_blocks(const thinbench_image* image,
                                       const thinbench_execution* execution, int64_t* count,
                                       thinbench_pixel* first) {
  return guarded([&] {
    require_pointer(count, "count");
    const FullBlocks found = full_blocks(image_of(image, "image"), execution_of(execution));
    *count = found.count;
    report(thinbench_pixel{found.first.x, found.first.y}, first);
  });
}

thinbench_status thinbench_skeleton_graph(const thinbench_image* skeleton,
                                          const thinbench_execution* execution,
                                          thinbench_graph** graph) {
  return give(graph, "graph", [&] {
    return graph_of(skeleton_graph(image_of(skeleton, "skeleton"), execution_of(execution)));
  });
}

thinbench_status thinbench_graph_of_labels(const thinbench_labels* skeletons,
                                           const thinbench_execution* execution,
                                           thinbench_graph** graph) {
  return give(graph, "graph", [&] {
    return graph_of(graph_of_labels(labels_of(skeletons, "skeletons"), execution_of(execution)));
  });
}

thinbench_status thinbench_split_graph(const thinbench_graph* graph, const thinbench_pixel* pixels,
                                       size_t count, thinbench_graph** split) {
  return give(split, "split", [&] {
    require_pointer(graph, "graph");
    return graph_of(split_graph(*graph, span_of<Pixel>(pixels, count, "pixels")));
  });
}

thinbench_status thinbench_prune(const thinbench_image* skeleton,
                                 const thinbench_image* destination,
                                 const thinbench_pruning* pruning,
                                 const thinbench_execution* execution, thinbench_graph** graph) {
  return give_if_wanted(graph, [&] {
    Graph found;
    write_to(destination, [&](const ImageView& to) {
      found =
          prune(image_of(skeleton, "skeleton"), to, pruning_of(pruning), execution_of(execution));
    });
    return graph_of(std::move(found));
  });
}

thinbench_status thinbench_prune_labels(const thinbench_labels* skeletons,
                                        const thinbench_labels* destination,
                                        const thinbench_pruning* pruning,
                                        const thinbench_execution* execution,
                                        thinbench_graph** graph) {
  return give_if_wanted(graph, [&] {
    return graph_of(prune_labels(labels_of(skeletons, "skeletons"),
                                 labels_of(destination, "destination"), pruning_of(pruning),
                                 execution_of(execution)));
  });
}

const thinbench_graph_node* thinbench_graph_nodes(const thinbench_graph* graph, size_t* count,
                                                  size_t size) {
  return list_of<thinbench_graph_node>(graph, &thinbench_graph::nodes, count, size);
}

const thinbench_graph_edge* thinbench_graph_edges(const thinbench_graph* graph, size_t* count,
                                                  size_t size) {
  return list_of<thinbench_graph_edge>(graph, &thinbench_graph::edges, count, size);
}

const thinbench_pixel* thinbench_graph_node_pixels(const thinbench_graph* graph, size_t* count,
                                                   size_t size) {
  return list_of<thinbench_pixel>(graph, &thinbench_graph::node_pixels, count, size);
}

const thinbench_pixel* thinbench_graph_edge_pixels(const thinbench_graph* graph, size_t* count,
                                                   size_t size) {
  return list_of<thinbench_pixel>(graph, &thinbench_graph::edge_pixels, count, size);
}

const int32_t* thinbench_graph_node_labels(const thinbench_graph* graph, size_t* count,
                                           size_t size) {
  return list_of<int32_t>(graph, &thinbench_graph::labels, count, size);
}

void thinbench_graph_destroy(thinbench_graph* graph) {
  delete graph;
}

thinbench_status thinbench_edge_widths(const thinbench_graph* graph,
                                       const thinbench_reals* distances,
                                       const thinbench_execution* execution,
                                       thinbench_widths* widths, size_t size) {
  return guarded([&] {
    require_pointer(graph, "graph");
    require(size == sizeof(thinbench_widths), [&] {
      return "size: expected " + std::to_string(sizeof(thinbench_widths)) + ", got " +
             std::to_string(size);
    });
    const auto found =
        edge_widths(*graph, reals_of(distances, "distances"), execution_of(execution));
    if (!found.empty()) require_pointer(widths, "widths");
    std::copy(found.begin(), found.end(), reinterpret_cast<EdgeWidths*>(widths));
  });
}

thinbench_status thinbench_polyline(const thinbench_pixel* points, size_t count, double tolerance,
                                    const thinbench_spacing* spacing, thinbench_pixel* kept,
                                    size_t* kept_count) {
  return guarded([&] {
    require_pointer(kept_count, "kept_count");
    if (count > 0) require_pointer(kept, "kept");
    const std::vector<Pixel> result =
        polyline(span_of<Pixel>(points, count, "points"), tolerance, spacing_of(spacing));
    std::copy(result.begin(), result.end(), reinterpret_cast<Pixel*>(kept));
    *kept_count = result.size();
  });
}
