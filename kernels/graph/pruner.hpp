// Pruning that looks again only at what it changed.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/plane_view.hpp"
#include "graph/joined.hpp"
#include "graph/walker.hpp"
#include "thinbench/graph.hpp"

namespace thinbench::detail {

/// Removes branches from an image, round after round; see thinbench/graph.hpp.
///
/// Removing a branch changes the class of one other pixel at most: of the junction pixel it led to,
/// which may become a line pixel. Then its junction may fall apart, and the lines on its two sides
/// are one line, perhaps a new branch. So a round visits the junctions that lost a branch; it takes
/// the steps of the lines that grew and of the smaller parts of junctions, never the whole image.
class Pruner {
 public:
  /// All of the same image; `node_at` gives its graph's nodes. The image changes, and the nodes of
  /// junction pixels.
  Pruner(const BitPlaneView& image, const ConstBitPlaneView& nodes, const NodeMap& node_at,
         const Graph& graph, const Pruning& pruning);

  void run();

 private:
  using JunctionId = std::uint32_t;

  /// From an end to a junction; `direction` leads from `stop`, a pixel of the junction.
  struct Branch {
    double length;
    Pixel end;
    Pixel stop;
    int direction;
  };
  // The order of edges in graphs: those whose end comes before the junction by their ends, then the
  // others by their places at the junction.
  struct ByEnd {
    bool operator()(const Branch& a, const Branch& b) const;
  };
  struct ByStop {
    bool operator()(const Branch& a, const Branch& b) const;
  };

  /// Pixels in raster order. Some of them, and branches that led to these, may have left: they are
  /// dropped when they come first.
  struct Junction {
    std::span<const Pixel> pixels;
    std::set<Branch, ByEnd> before;
    std::set<Branch, ByStop> after;
  };

  /// A line followed from a pixel to the first pixel that is none, or to where it began.
  struct Line {
    Pixel stop;
    int direction;  // of the last step
    Steps steps;
  };

  /// Pixels of a junction that are joined, as far as they are known.
  struct Part {
    JunctionId id;
    std::vector<Pixel> pixels;
    std::size_t visited = 0;
  };

  [[nodiscard]] bool foreground(Pixel p) const { return bit_at(image_, p); }
  [[nodiscard]] DirectionSet joined(Pixel p) const { return kJoined[window_at(image_, p)]; }
  [[nodiscard]] bool is_line(Pixel p) const {
    return foreground(p) && kIsLine[window_at(image_, p)];
  }
  [[nodiscard]] bool is_junction(Pixel p) const;
  [[nodiscard]] bool belongs(Pixel p, JunctionId id) const {
    return is_junction(p) && node_at_[p] == id;
  }
  [[nodiscard]] double limit_at(Pixel stop) const;
  [[nodiscard]] Junction& junction(JunctionId id) { return junctions_[id - 1]; }

  template <class Visit>
  Line follow(Pixel from, Visit visit, int direction) const;
  void clear_line(Pixel end, bool with_stop);

  void look_at_end(Pixel end);
  void add(JunctionId id, const Branch& branch);
  std::optional<Branch> take_shortest(JunctionId id);
  void drop_first_pixels(JunctionId id);

  void start();
  bool remove_round();
  void split(JunctionId id, Pixel gone);
  bool grow(Part& part, JunctionId from, JunctionId other);
  void rename(const Part& part, JunctionId id);
  void add_junction(Part& part);
  void join_lines_at(Pixel p);

  BitPlaneView image_;
  ConstBitPlaneView nodes_;
  NodeMap node_at_;
  const Graph& graph_;
  const Pruning& pruning_;
  std::vector<Junction> junctions_;       // of every node number, counted from 1
  std::deque<std::vector<Pixel>> parts_;  // pixels of junctions that are not in the graph
  std::vector<JunctionId> active_;        // with branches, perhaps
};

}  // namespace thinbench::detail
