// The C interface of graphs.
#include "api/c_graph.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

#include "api/c_arguments.hpp"
#include "core/checks.hpp"
#include "thinbench.h"

static_assert(sizeof(thinbench_graph_node) == sizeof(thinbench::GraphNode));
static_assert(sizeof(thinbench_graph_edge) == sizeof(thinbench::GraphEdge));
static_assert(sizeof(thinbench_pixel) == sizeof(thinbench::Pixel));
static_assert(offsetof(thinbench_graph_node, pixel_count) ==
              offsetof(thinbench::GraphNode, pixel_count));
static_assert(offsetof(thinbench_graph_edge, horizontal_steps) ==
              offsetof(thinbench::GraphEdge, steps));

using namespace thinbench;
using namespace thinbench::detail;

Pruning thinbench::detail::pruning_of(const thinbench_pruning* pruning, Index width, Index height) {
  require_pointer(pruning, "pruning");
  const thinbench_pruning defaults = THINBENCH_PRUNING_INIT;
  const auto given = versioned(pruning, &thinbench_pruning::spacing, defaults, "pruning",
                               "THINBENCH_PRUNING_INIT");
  Pruning result = {.min_length = given.min_length, .min_widths = given.min_widths};
  result.removes_components = given.removes_components != 0;
  if (given.distances != nullptr) {
    result.distances = {given.distances, width, height, given.distances_stride};
  }
  result.spacing = spacing_of(given.spacing);
  return result;
}

thinbench_status thinbench_classify_pixels(const thinbench_stack* image, uint8_t* classes,
                                           ptrdiff_t classes_stride, uint8_t* degrees,
                                           ptrdiff_t degrees_stride) {
  return guarded([&] {
    const ConstImageView source = image_of(image);
    classify_pixels(source, {classes, source.width, source.height, classes_stride},
                    {degrees, source.width, source.height, degrees_stride});
  });
}

thinbench_status thinbench_full_blocks(const thinbench_stack* image, int64_t* count,
                                       thinbench_pixel* first) {
  return guarded([&] {
    require_pointer(count, "count");
    const FullBlocks found = full_blocks(image_of(image));
    *count = found.count;
    if (first != nullptr) *first = {found.first.x, found.first.y};
  });
}

thinbench_status thinbench_skeleton_graph(const thinbench_stack* skeleton,
                                          const thinbench_execution* execution,
                                          thinbench_graph** graph) {
  return guarded([&] {
    require_pointer(graph, "graph");
    *graph = nullptr;
    *graph = new thinbench_graph{{skeleton_graph(image_of(skeleton), execution_of(execution))}, {}};
  });
}

thinbench_status thinbench_prune(const thinbench_stack* skeleton,
                                 const thinbench_output* destination,
                                 const thinbench_pruning* pruning,
                                 const thinbench_execution* execution, thinbench_graph** graph) {
  return guarded([&] {
    if (graph != nullptr) *graph = nullptr;
    const ConstImageView image = image_of(skeleton);
    const StackView target = destination_of(destination, source_of(skeleton));
    auto found = std::make_unique<thinbench_graph>();
    static_cast<Graph&>(*found) =
        prune(image, target.image(0), pruning_of(pruning, image.width, image.height),
              execution_of(execution));
    set_foreground(destination, target);
    if (graph != nullptr) *graph = found.release();
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

void thinbench_graph_destroy(thinbench_graph* graph) {
  delete graph;
}

thinbench_status thinbench_graph_edge_widths(const thinbench_graph* graph, const double* distances,
                                             ptrdiff_t stride, ptrdiff_t height, ptrdiff_t width,
                                             thinbench_edge_widths* widths) {
  return guarded([&] {
    require_pointer(graph, "graph");
    if (graph->edges.empty()) return;
    require_pointer(widths, "widths");
    const auto found = edge_widths(*graph, {distances, width, height, stride});
    for (const auto& [mean, median, min, max] : found) {
      *widths++ = {mean, median, min, max};
    }
  });
}

thinbench_status thinbench_polyline(const thinbench_pixel* points, size_t count, double tolerance,
                                    const thinbench_spacing* spacing, thinbench_pixel* kept,
                                    size_t* kept_count) {
  return guarded([&] {
    require_pointer(kept_count, "kept_count");
    if (count > 0) {
      require_pointer(points, "points");
      require_pointer(kept, "kept");
    }
    const std::vector<Pixel> result =
        polyline({reinterpret_cast<const Pixel*>(points), count}, tolerance, spacing_of(spacing));
    std::copy(result.begin(), result.end(), reinterpret_cast<Pixel*>(kept));
    *kept_count = result.size();
  });
}
