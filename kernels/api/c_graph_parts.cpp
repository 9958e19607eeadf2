// The C interface of graphs of labels, and of graphs made from others.
#include <cstddef>
#include <memory>
#include <utility>

#include "api/c_graph.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/graph_parts.hpp"

static_assert(sizeof(thinbench_graph_place) == sizeof(thinbench::GraphPlace));
static_assert(sizeof(thinbench_branch) == sizeof(thinbench::Branch));
static_assert(offsetof(thinbench_branch, length) == offsetof(thinbench::Branch, length));

namespace {

using namespace thinbench;
using namespace thinbench::detail;

thinbench_graph* with_labels(LabelGraph found) {
  return new thinbench_graph{{std::move(found.graph)}, std::move(found.labels)};
}

/// What `make(graph)` returns, as a handle.
template <class Make>
thinbench_status give(const thinbench_graph* graph, thinbench_graph** made, const char* name,
                      const Make& make) {
  return guarded([&] {
    require_pointer(made, name);
    *made = nullptr;
    require_pointer(graph, "graph");
    *made = new thinbench_graph{{make(*graph)}, {}};
  });
}

/// A list of the caller, which may be NULL without elements.
template <class T, class Struct>
std::span<const T> list_from(const Struct* list, size_t count, const char* name) {
  static_assert(sizeof(T) == sizeof(Struct));
  if (count > 0) require_pointer(list, name);
  return {reinterpret_cast<const T*>(list), count};
}

}  // namespace

thinbench_status thinbench_graph_of_labels(const int32_t* skeletons, ptrdiff_t stride,
                                           ptrdiff_t height, ptrdiff_t width,
                                           const thinbench_execution* execution,
                                           thinbench_graph** graph) {
  return guarded([&] {
    require_pointer(graph, "graph");
    *graph = nullptr;
    *graph =
        with_labels(graph_of_labels({skeletons, width, height, stride}, execution_of(execution)));
  });
}

const int32_t* thinbench_graph_node_labels(const thinbench_graph* graph, size_t* count,
                                           size_t size) {
  return list_of<int32_t>(graph, &thinbench_graph::labels, count, size);
}

thinbench_status thinbench_label_distances(const int32_t* labels, ptrdiff_t labels_stride,
                                           double* distances, ptrdiff_t distances_stride,
                                           ptrdiff_t height, ptrdiff_t width,
                                           const thinbench_spacing* spacing,
                                           const thinbench_execution* execution) {
  return guarded([&] {
    distances_of_labels({labels, width, height, labels_stride},
                    {distances, width, height, distances_stride}, spacing_of(spacing),
                    execution_of(execution));
  });
}

thinbench_status thinbench_prune_labels(const int32_t* skeletons, ptrdiff_t skeletons_stride,
                                        int32_t* destination, ptrdiff_t destination_stride,
                                        ptrdiff_t height, ptrdiff_t width,
                                        const thinbench_pruning* pruning,
                                        const thinbench_execution* execution,
                                        thinbench_graph** graph) {
  return guarded([&] {
    if (graph != nullptr) *graph = nullptr;
    LabelGraph found = prune_labels({skeletons, width, height, skeletons_stride},
                                    {destination, width, height, destination_stride},
                                    pruning_of(pruning, width, height), execution_of(execution));
    if (graph != nullptr) *graph = with_labels(std::move(found));
  });
}

thinbench_status thinbench_graph_subgraph(const thinbench_graph* graph, const uint32_t* edges,
                                          size_t count, thinbench_graph** part) {
  return give(graph, part, "part", [&](const Graph& whole) {
    return subgraph(whole, list_from<uint32_t>(edges, count, "edges"));
  });
}

thinbench_status thinbench_graph_split(const thinbench_graph* graph, const thinbench_pixel* pixels,
                                       size_t count, thinbench_graph** split) {
  return give(graph, split, "split", [&](const Graph& whole) {
    return split_graph(whole, list_from<Pixel>(pixels, count, "pixels"));
  });
}

thinbench_status thinbench_graph_open_cycles(const thinbench_graph* graph, double max_length,
                                             const thinbench_spacing* spacing,
                                             thinbench_graph** opened) {
  return give(graph, opened, "opened", [&](const Graph& whole) {
    return open_cycles(whole, max_length, spacing_of(spacing));
  });
}

thinbench_status thinbench_graph_nearest(const thinbench_graph* graph, double x, double y,
                                         const thinbench_spacing* spacing,
                                         thinbench_graph_place* place) {
  return guarded([&] {
    require_pointer(graph, "graph");
    require_pointer(place, "place");
    const auto [edge, pixel, distance] = nearest_place(*graph, x, y, spacing_of(spacing));
    *place = {edge, {pixel.x, pixel.y}, distance};
  });
}

thinbench_status thinbench_graph_summary(const thinbench_graph* graph,
                                         const thinbench_spacing* spacing,
                                         thinbench_branch* branches) {
  return guarded([&] {
    require_pointer(graph, "graph");
    if (graph->edges.empty()) return;
    require_pointer(branches, "branches");
    for (const Branch& row : thinbench::branches(*graph, spacing_of(spacing))) {
      *branches++ = {row.component,
                     row.from,
                     row.to,
                     static_cast<int32_t>(row.type),
                     {row.start.x, row.start.y},
                     {row.stop.x, row.stop.y},
                     row.length,
                     row.chord,
                     row.tortuosity};
    }
  });
}
