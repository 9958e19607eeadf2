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
///
/// A main path may begin or end at a pixel of a line instead. Then only a part of its first edge is
/// on it, from `first_point` to the first node, or of its last edge, from the last node to
/// `last_point`. If the edge is a loop, that is the shorter part, of equal ones the one at its
/// start. Without nodes, it leads from one point to the other along one edge.
struct GraphPath {
  double length = 0;
  std::vector<std::uint32_t> nodes;
  std::vector<std::uint32_t> edges;
  std::optional<std::uint32_t> first_point = {};  // in pixels_of() the first edge
  std::optional<std::uint32_t> last_point = {};   // in those of the last

  friend bool operator==(const GraphPath&, const GraphPath&) = default;
};

/// For each component, the longest of the shortest paths between two of its points: its nodes and
/// the pixels of its lines. Steps within a node have no length. Of paths that are equally long, up
/// to 10^-12 of their length, the one with the lowest first point, then with the lowest last one;
/// nodes come before pixels, and these in the order of Graph. A component of one node has a path
/// without edges.
///
/// A component without cycles, whose main path leads from node to node, takes the time of three
/// searches for shortest paths between nodes. One with cycles takes as many as are needed to rule
/// out all other nodes and lines by what searches say of their distances: a few for most skeletons,
/// at worst two for each edge, and then the time to compare all pairs of edges.
///
/// Throws std::invalid_argument for edges between other nodes and for a spacing as distances(), and
/// std::bad_alloc. Source: F. Takes and W. Kosters 2011, "Determining the diameter of small world
/// networks".
[[nodiscard]] THINBENCH_API std::vector<GraphPath> main_paths(const Graph& graph,
                                                              const Spacing& spacing = {});

/// The pixels along a path of the graph, with the spacing that it was found with. In a node of
/// several pixels it goes straight from one edge to the next; that of one node has its first pixel.
/// Throws std::invalid_argument for what is not in the graph and for a spacing as distances().
[[nodiscard]] THINBENCH_API std::vector<Pixel> points_of(const Graph& graph, const GraphPath& path,
                                                         const Spacing& spacing = {});

// The functions below take links between nodes with the numbers 0 to `nodes` - 1. Thread-safe. They
// throw std::invalid_argument for a link to another node and for a length that is not a finite
// number of at least 0, and std::bad_alloc.

/// The component of every node. Components are numbered from 0, by their first nodes.
[[nodiscard]] THINBENCH_API std::vector<std::uint32_t> components_of(std::uint32_t nodes,
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
