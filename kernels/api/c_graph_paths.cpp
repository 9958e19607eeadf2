// The C interface of paths through graphs.
#include <algorithm>
#include <cstddef>
#include <memory>

#include "api/c_arguments.hpp"
#include "thinbench.h"
#include "thinbench/graph_paths.hpp"

static_assert(sizeof(thinbench_link) == sizeof(thinbench::Link));
static_assert(offsetof(thinbench_link, length) == offsetof(thinbench::Link, length));

struct thinbench_graph_paths {
  std::vector<thinbench_graph_path> list;
  std::vector<uint32_t> nodes;
  std::vector<uint32_t> edges;
};

namespace {

using namespace thinbench;
using namespace thinbench::detail;

std::span<const Link> links_from(const thinbench_link* links, size_t count) {
  if (count > 0) require_pointer(links, "links");
  return {reinterpret_cast<const Link*>(links), count};
}

void append(thinbench_graph_paths& paths, const GraphPath& path) {
  paths.list.push_back(
      {path.length, paths.nodes.size(), path.nodes.size(), paths.edges.size(), path.edges.size()});
  paths.nodes.insert(paths.nodes.end(), path.nodes.begin(), path.nodes.end());
  paths.edges.insert(paths.edges.end(), path.edges.begin(), path.edges.end());
}

/// Of what `find()` returns.
template <class Find>
thinbench_status give(thinbench_graph_paths** paths, const Find& find) {
  return guarded([&] {
    require_pointer(paths, "paths");
    *paths = nullptr;
    auto found = std::make_unique<thinbench_graph_paths>();
    for (const GraphPath& path : find()) append(*found, path);
    *paths = found.release();
  });
}

}  // namespace

thinbench_status thinbench_main_paths(uint32_t nodes, const thinbench_link* links,
                                      size_t link_count, thinbench_graph_paths** paths) {
  return give(paths, [&] { return main_paths(nodes, links_from(links, link_count)); });
}

thinbench_status thinbench_cycles(uint32_t nodes, const thinbench_link* links, size_t link_count,
                                  thinbench_graph_paths** paths) {
  return give(paths, [&] { return cycles(nodes, links_from(links, link_count)); });
}

thinbench_status thinbench_shortest_path(uint32_t nodes, const thinbench_link* links,
                                         size_t link_count, uint32_t from, uint32_t to,
                                         thinbench_graph_paths** paths) {
  return give(paths, [&] {
    const auto found = shortest_path(nodes, links_from(links, link_count), from, to);
    return found ? std::vector<GraphPath>{*found} : std::vector<GraphPath>();
  });
}

thinbench_status thinbench_components(uint32_t nodes, const thinbench_link* links,
                                      size_t link_count, uint32_t* components) {
  return guarded([&] {
    if (nodes > 0) require_pointer(components, "components");
    std::ranges::copy(components_of(nodes, links_from(links, link_count)), components);
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
