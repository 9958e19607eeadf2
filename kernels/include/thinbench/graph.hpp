// The graph of a skeleton: ends, junctions and the lines between them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "thinbench/distance.hpp"
#include "thinbench/export.h"
#include "thinbench/image_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench {

// Two foreground pixels are joined if they are 4-neighbours, or diagonal neighbours without a
// common 4-neighbour in the foreground. So a corner has one way round, not two:
//
//   # #        joined: each 4-neighbour, and the two steps            # .  joined diagonally
//   # .        between them; the diagonal of this corner is not      . #
//
// The degree of a pixel is its number of joined neighbours, at most 4. By degree a pixel is
//   0  isolated     1  an end     2  a line pixel     3, 4  a junction pixel
// and every pixel of a full block of 2 x 2 is a junction pixel, which thin images hardly have.
// Junction pixels that are joined form one junction.

struct Pixel {
  std::int32_t x;
  std::int32_t y;

  friend constexpr bool operator==(Pixel, Pixel) = default;
};

enum class NodeKind : std::int32_t {
  isolated,  // a pixel alone
  end,
  junction,  // one pixel or several
  cycle,     // the first pixel of a closed line without junctions
  given,     // a pixel of a line, by split_graph(): thinbench/graph_parts.hpp
};

inline constexpr std::array<std::string_view, 5> kNodeKindNames = {"isolated", "end", "junction",
                                                                   "cycle", "given"};

/// What a pixel is. Ends and isolated pixels are nodes; joined junction pixels are one.
enum class PixelClass : std::uint8_t { background, isolated, end, line, junction };

/// Writes the PixelClass of every pixel of a binary image (0 is background) and its degree: how
/// many neighbours it is joined to, 0 to 4, and 0 on background. A view without data is left out.
///
/// Views with data must have the size of the image and share no pixel with another. Thread-safe for
/// different destinations. Throws std::invalid_argument for unsuitable views, a side above 2^29 or
/// more than 2^31 pixels, and std::bad_alloc; then nothing is written.
THINBENCH_API void classify_pixels(ConstImageView image, ImageView classes, ImageView degrees,
                                   const Execution& execution = {});

/// Blocks of 2 x 2 foreground pixels, by which an image is not thin.
struct FullBlocks {
  std::int64_t count = 0;
  Pixel first = {0, 0};  // the upper left pixel of the first in raster order

  friend bool operator==(const FullBlocks&, const FullBlocks&) = default;
};

/// Counts them; they may overlap. Thread-safe. Throws std::invalid_argument as skeleton_graph does.
[[nodiscard]] THINBENCH_API FullBlocks full_blocks(ConstImageView image,
                                                   const Execution& execution = {});

struct GraphNode {
  NodeKind kind;
  std::uint32_t first_pixel;  // of its pixels in Graph::node_pixels
  std::uint32_t pixel_count;

  friend constexpr bool operator==(const GraphNode&, const GraphNode&) = default;
};

/// The steps of a line from pixel to pixel.
struct Steps {
  std::uint32_t horizontal = 0;
  std::uint32_t vertical = 0;
  std::uint32_t diagonal = 0;

  friend constexpr bool operator==(const Steps&, const Steps&) = default;
};

/// horizontal * spacing.x + vertical * spacing.y + diagonal * sqrt(spacing.x^2 + spacing.y^2).
[[nodiscard]] THINBENCH_API double length_of(const Steps& steps, const Spacing& spacing = {});

/// A line between two nodes, or from a node to itself: from `start`, a pixel of node `from`, by the
/// pixels of the line to `stop`, a pixel of node `to`. A loop within a junction, round a hole that
/// its pixels enclose, has no pixels and no steps.
struct GraphEdge {
  std::uint32_t from;
  std::uint32_t to;  // at least `from`
  Pixel start;
  Pixel stop;
  std::uint32_t first_pixel;  // of its pixels in Graph::edge_pixels
  std::uint32_t pixel_count;
  Steps steps;

  friend constexpr bool operator==(const GraphEdge&, const GraphEdge&) = default;
};

/// Every foreground pixel is in one of both lists of pixels, once. The number of nodes minus that
/// of edges is the 8-connected Euler number of the image.
///
/// Order: nodes but cycles by their first pixels in raster order, then cycles likewise; pixels of a
/// node in raster order; edges by `from`, then by `start`, then by the direction of the first step:
/// east, south-east, south and so on; loops within a junction come last. Pixels of an edge from
/// `start` to `stop`.
struct Graph {
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
  std::vector<Pixel> node_pixels;
  std::vector<Pixel> edge_pixels;

  [[nodiscard]] std::span<const Pixel> pixels_of(const GraphNode& node) const {
    return {node_pixels.data() + node.first_pixel, node.pixel_count};
  }
  [[nodiscard]] std::span<const Pixel> pixels_of(const GraphEdge& edge) const {
    return {edge_pixels.data() + edge.first_pixel, edge.pixel_count};
  }

  friend bool operator==(const Graph&, const Graph&) = default;
};

/// The graph of a binary image, usually a skeleton: 0 is background, anything else foreground,
/// everything outside the image background. A thick image is no error; its full blocks become
/// junctions.
///
/// Takes 4 bytes of memory per pixel beside three times the result. Thread-safe. Throws
/// std::invalid_argument for a negative size, a stride below the width, a null image, a side above
/// 2^29 or more than 2^31 pixels, threads out of range and an ISA that is not available, and
/// std::bad_alloc. Use full_blocks() to reject images that are not thin.
[[nodiscard]] THINBENCH_API Graph skeleton_graph(ConstImageView skeleton,
                                                 const Execution& execution = {});

[[nodiscard]] inline double length_of(const GraphEdge& edge, const Spacing& spacing = {}) {
  return length_of(edge.steps, spacing);
}

/// Which branches prune() removes.
struct Pruning {
  double min_length = 0;  // branches below it, in the unit of the spacing
  /// And branches below this many times the object's width at their junction, which is twice the
  /// distance to the background there.
  double min_widths = 0;
  /// Of the image before it was thinned: distances() with the same spacing. Used with min_widths
  /// only.
  View<const double> distances = {};
  /// Also components that are a line or a pixel below min_length. Otherwise no component
  /// disappears.
  bool removes_components = false;
  Spacing spacing = {};
};

/// Removes short branches from a skeleton: lines from an end to a junction, with the end but
/// without the junction. Each round removes the shortest short branch of every junction, of equal
/// ones the first, until none is left; what is left of a junction with two branches is a line, and
/// may be long. Holes remain, and so do components unless Pruning says otherwise. Returns the graph
/// of the result.
///
/// A round takes the time of what it changes. Takes memory as skeleton_graph, and some hundred
/// bytes for each node.
///
/// `destination` gets 0 and 255. Views must have the same size and be the same image or share no
/// pixel. Errors as skeleton_graph; std::invalid_argument also for a negative or infinite limit,
/// for distances that are missing or of another size, and for a spacing as distances(). Nothing is
/// written if it throws.
THINBENCH_API Graph prune(ConstImageView skeleton, ImageView destination, const Pruning& pruning,
                          const Execution& execution = {});

/// The widths along a line, from its start to its stop, both included: twice the distance to the
/// background; infinite in an image without background.
struct EdgeWidths {
  double mean;
  double median;  // the mean of the two in the middle of an even number
  double min;
  double max;
};

/// `distances` are those of the image before it was thinned. Throws std::invalid_argument if they
/// have no data or a stride below their width, or lack a pixel of an edge.
[[nodiscard]] THINBENCH_API std::vector<EdgeWidths> edge_widths(const Graph& graph,
                                                                View<const double> distances,
                                                                const Execution& execution = {});

/// The pixels along an edge: start, those of the line, stop.
[[nodiscard]] THINBENCH_API std::vector<Pixel> points_of(const Graph& graph, const GraphEdge& edge);

/// Of the points of a line, the first, the last and some between them, chosen so that no point is
/// farther than `tolerance` from the polyline (Douglas and Peucker 1973; of points that are equally
/// far, a line is split at the first). Each split looks at corners of O(log n) convex hulls of
/// parts of the line, not at every point. The tolerance has the unit of the spacing. Throws
/// std::invalid_argument for a negative or infinite tolerance and for a spacing as distances().
[[nodiscard]] THINBENCH_API std::vector<Pixel> polyline(std::span<const Pixel> points,
                                                        double tolerance,
                                                        const Spacing& spacing = {});

/// Of the straight lines between points, in the unit of the spacing: with those of polyline() a
/// smoothed length of an edge, which depends less on its direction than that of its steps.
[[nodiscard]] THINBENCH_API double length_of(std::span<const Pixel> points,
                                             const Spacing& spacing = {});

}  // namespace thinbench
