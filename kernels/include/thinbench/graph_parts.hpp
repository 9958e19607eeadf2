// Graphs made from other graphs, and what graphs say of their edges.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "thinbench/export.h"
#include "thinbench/graph.hpp"
#include "thinbench/image_view.hpp"

namespace thinbench {

// Thread-safe. The functions below throw std::invalid_argument for what is not in the graph and for
// a spacing as distances(), and std::bad_alloc.

/// Some edges, by their numbers, in this order, and their nodes, in that of the graph. Kinds of
/// nodes remain.
[[nodiscard]] THINBENCH_API Graph subgraph(const Graph& graph,
                                           std::span<const std::uint32_t> edges);

/// The graph with a node of the kind `given` at each pixel, after the other nodes. It splits its
/// edge in two, one from each of the former nodes to the new one, in the place of the edge. Pixels
/// of nodes change nothing; others must be pixels of lines. Each split takes the time of a copy.
[[nodiscard]] THINBENCH_API Graph split_graph(const Graph& graph, std::span<const Pixel> pixels);

/// The graph without the closing edges of its cycles() of at most max_length: without the
/// longest edges of short cycles, of equally long ones the last. All nodes remain.
[[nodiscard]] THINBENCH_API Graph
open_cycles(const Graph& graph, double max_length = std::numeric_limits<double>::infinity(),
            const Spacing& spacing = {});

/// A pixel of an edge, its start and stop included, and how far it is from where it was looked for.
struct GraphPlace {
  std::uint32_t edge;
  Pixel pixel;
  double distance;

  friend constexpr bool operator==(const GraphPlace&, const GraphPlace&) = default;
};

/// The pixel of an edge that is nearest to a point, the first with the least `distance` as a
/// double; x and y are numbers of columns and rows, the distance is in the unit of the spacing.
/// Throws std::invalid_argument also for a graph without edges and for a point that is not finite.
[[nodiscard]] THINBENCH_API GraphPlace nearest_place(const Graph& graph, double x, double y,
                                                     const Spacing& spacing = {});

/// Writes to each pixel of an edge the number of the edge, counted from 1, and 0 to all others. A
/// node with one edge belongs to it, such as an end or the first pixel of a closed line; where
/// edges meet is 0. Lines that meet at a junction have labels of their own, though pixels beside
/// the junction may be neighbours.
///
/// Throws std::invalid_argument also for an unsuitable view and for one that lacks a pixel of the
/// graph; then nothing is written.
THINBENCH_API void edge_labels(const Graph& graph, LabelView destination);

/// What an edge leads between. Nodes that are no ends count as junctions.
enum class EdgeType : std::int32_t { end_end, end_junction, junction_junction, cycle };

/// An edge as a row of the table that skan's summarize() makes.
struct EdgeSummary {
  std::uint32_t component;  // of components_of()
  std::uint32_t from;
  std::uint32_t to;
  EdgeType type;
  Pixel start;
  Pixel stop;
  double length;
  double chord;       // the distance between start and stop
  double tortuosity;  // length / chord; NaN where start and stop are one pixel
};

/// A row for each edge, in the order of the edges.
[[nodiscard]] THINBENCH_API std::vector<EdgeSummary> summary(const Graph& graph,
                                                             const Spacing& spacing = {});

}  // namespace thinbench
