// Paths through graphs: the main path of each component, and cycles.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "thinbench/export.h"
#include "thinbench/graph.hpp"

namespace thinbench {

/// An edge between two nodes, or from a node to itself.
struct Link {
  std::uint32_t from;
  std::uint32_t to;
  double length;
};

/// The edges of a graph, with their lengths in the unit of the spacing. Throws
/// std::invalid_argument for a spacing as distances().
[[nodiscard]] THINBENCH_API std::vector<Link> links_of(const Graph& graph,
                                                       const Spacing& spacing = {});

/// From node to node by links, whose numbers are positions in their list.
struct GraphPath {
  double length = 0;
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> edges;

  friend bool operator==(const GraphPath&, const GraphPath&) = default;
};

// The functions below take links between nodes with the numbers 0 to `nodes` - 1. Thread-safe. They
// throw std::invalid_argument for a link to another node and for a length that is not a finite
// number of at least 0, and std::bad_alloc.

/// The component of every node. Components are numbered from 0, by their first nodes.
[[nodiscard]] THINBENCH_API std::vector<std::uint32_t> components_of(std::uint32_t nodes,
                                                                     std::span<const Link> links);

/// For each component, the longest of the shortest paths between two of its nodes. Of paths that
/// are equally long, up to 10^-12 of their length, the one with the lowest first node, then with
/// the lowest last one. A component of one node has a path without edges.
///
/// A component without cycles takes the time of three searches. One with cycles takes as many as
/// are needed to rule out all other nodes by what searches say of their distances: a few for most
/// skeletons, at worst one for each node.
///
/// Source: F. Takes and W. Kosters 2011, "Determining the diameter of small world networks".
[[nodiscard]] THINBENCH_API std::vector<GraphPath> main_paths(std::uint32_t nodes,
                                                              std::span<const Link> links);

/// A cycle basis: one cycle for each link outside the minimum spanning forest, which that link
/// closes. There are links - nodes + components, in the order of these links; of equally long
/// links, the forest takes the first. The closing link is the longest of its cycle, and its last;
/// from its last node it leads to the first.
[[nodiscard]] THINBENCH_API std::vector<GraphPath> cycles(std::uint32_t nodes,
                                                          std::span<const Link> links);

/// The shortest path between two nodes, if there is one. Throws std::invalid_argument for other
/// nodes.
[[nodiscard]] THINBENCH_API std::optional<GraphPath> shortest_path(std::uint32_t nodes,
                                                                   std::span<const Link> links,
                                                                   std::uint32_t from,
                                                                   std::uint32_t to);

}  // namespace thinbench
