// The C interface of paths through graphs and maps.
#include <algorithm>
#include <cstddef>

#include "api/c_arguments.hpp"
#include "graph/main_paths.hpp"
#include "thinbench/graph_paths.hpp"
#include "thinbench/path.hpp"

static_assert(offsetof(thinbench_link, length) == offsetof(thinbench::Link, length));

struct thinbench_graph_paths {
  std::vector<thinbench_graph_path> list;
  std::vector<uint32_t> nodes;
  std::vector<uint32_t> edges;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

int64_t number_of(std::optional<std::uint32_t> point) {
  return point ? int64_t{*point} : -1;
}

thinbench_graph_paths joined(const std::vector<GraphPath>& paths) {
  thinbench_graph_paths all;
  for (const auto& [length, nodes, edges, first_point, last_point] : paths) {
    all.list.push_back({length, all.nodes.size(), nodes.size(), all.edges.size(), edges.size(),
                        number_of(first_point), number_of(last_point)});
    all.nodes.insert(all.nodes.end(), nodes.begin(), nodes.end());
    all.edges.insert(all.edges.end(), edges.begin(), edges.end());
  }
  return all;
}

std::span<const Link> links_of(const thinbench_link* links, size_t count) {
  return span_of<Link>(links, count, "links");
}

PathRequest request_of(const thinbench_path_request* request) {
  const auto from = known(request, thinbench_path_request THINBENCH_PATH_REQUEST_INIT, "request");
  return {{from.start.x, from.start.y}, {from.goal.x, from.goal.y}, from.width};
}

}  // namespace

thinbench_status thinbench_main_paths(uint32_t nodes, const thinbench_graph_edge* edges,
                                      size_t edge_count, const thinbench_pixel* pixels,
                                      size_t pixel_count, const thinbench_spacing* spacing,
                                      thinbench_graph_paths** paths) {
  return give(paths, "paths", [&] {
    return joined(main_paths(nodes, span_of<GraphEdge>(edges, edge_count, "edges"),
                             span_of<Pixel>(pixels, pixel_count, "pixels"), spacing_of(spacing)));
  });
}

thinbench_status thinbench_cycles(uint32_t nodes, const thinbench_link* links, size_t link_count,
                                  thinbench_graph_paths** paths) {
  return give(paths, "paths", [&] { return joined(cycles(nodes, links_of(links, link_count))); });
}

thinbench_status thinbench_shortest_path(uint32_t nodes, const thinbench_link* links,
                                         size_t link_count, uint32_t from, uint32_t to,
                                         thinbench_graph_paths** paths) {
  return give(paths, "paths", [&] {
    const auto found = shortest_path(nodes, links_of(links, link_count), from, to);
    return found ? joined({*found}) : thinbench_graph_paths();
  });
}

thinbench_status thinbench_components_of(uint32_t nodes, const thinbench_link* links,
                                         size_t link_count, uint32_t* components) {
  return guarded([&] {
    if (nodes > 0) require_pointer(components, "components");
    const std::vector<std::uint32_t> found = components_of(nodes, links_of(links, link_count));
    std::copy(found.begin(), found.end(), components);
  });
}

const thinbench_graph_path* thinbench_graph_paths_list(const thinbench_graph_paths* paths,
                                                       size_t* count, size_t size) {
  return list_of<thinbench_graph_path>(paths, &thinbench_graph_paths::list, count, size);
}

const uint32_t* thinbench_graph_paths_nodes(const thinbench_graph_paths* paths, size_t* count,
                                            size_t size) {
  return list_of<uint32_t>(paths, &thinbench_graph_paths::nodes, count, size);
}

const uint32_t* thinbench_graph_paths_edges(const thinbench_graph_paths* paths, size_t* count,
                                            size_t size) {
  return list_of<uint32_t>(paths, &thinbench_graph_paths::edges, count, size);
}

void thinbench_graph_paths_destroy(thinbench_graph_paths* paths) {
  delete paths;
}

thinbench_status thinbench_find_path(const thinbench_image* free,
                                     const thinbench_path_request* request,
                                     const thinbench_execution* execution, thinbench_pixel* pixels,
                                     size_t capacity, thinbench_found_path* found) {
  return guarded([&] {
    if (capacity > 0) require_pointer(pixels, "pixels");
    auto result = fresh(found, thinbench_found_path THINBENCH_FOUND_PATH_INIT, "found");
    const std::optional<FoundPath> path =
        find_path(image_of(free, "free"), request_of(request), execution_of(execution));
    if (path) {
      std::copy_n(path->pixels.begin(), std::min(capacity, path->pixels.size()),
                  reinterpret_cast<Pixel*>(pixels));
      result.count = path->pixels.size();
      result.length = path->length;
      result.min_width = path->min_width;
    }
    give_known(result, found);
  });
}
