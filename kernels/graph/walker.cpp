#include "graph/walker.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "graph/joined.hpp"

namespace thinbench::detail {
namespace {

/// Calls `body(pixel)` for every set pixel in raster order. It may clear pixels.
template <class Body>
void for_pixels(const ConstBitPlaneView& plane, const Body& body) {
  for (Index y = 0; y < plane.height; ++y) {
    const std::uint64_t* const row = plane.row(y);
    for (Index i = 0; i * kWordBits < plane.width; ++i) {
      std::uint64_t left = row[i];
      while (left != 0) {
        const int bit = std::countr_zero(left);
        body(Pixel{static_cast<std::int32_t>(i * kWordBits + bit), static_cast<std::int32_t>(y)});
        left = row[i] & ~((std::uint64_t{2} << bit) - 1);
      }
    }
  }
}

std::uint32_t number(std::size_t size) {
  return static_cast<std::uint32_t>(size);
}

}  // namespace

/// One call of walk().
class GraphWalker::Walk {
 public:
  Walk(GraphWalker& walker, const ConstBitPlaneView& image, const ConstBitPlaneView& nodes,
       const BitPlaneView& lines)
      : walker_(walker), graph_(walker.graph_), image_(image), nodes_(nodes), lines_(lines) {}

  void run() {
    for_pixels(nodes_, [&](Pixel p) { node_at(p) = 0; });
    for_pixels(nodes_, [&](Pixel p) {
      if (node_at(p) == 0) add_node_at(p);
    });
    const std::uint32_t open_nodes = number(graph_.nodes.size());
    for (std::uint32_t node = 0; node < open_nodes; ++node) add_edges(node);
    for_pixels(lines_, [&](Pixel p) { add_cycle(p); });
  }

 private:
  [[nodiscard]] std::uint32_t& node_at(Pixel p) { return walker_.node_at()[p]; }

  [[nodiscard]] unsigned window(Pixel p) const { return window_at(image_, p); }
  [[nodiscard]] DirectionSet joined(Pixel p) const { return kJoined[window(p)]; }

  [[nodiscard]] bool is_node(Pixel p) const { return bit_at(nodes_, p); }
  [[nodiscard]] bool is_line(Pixel p) const { return bit_at(lines_, p); }

  void take_line(Pixel p) {
    clear_bit(lines_, p);
    graph_.edge_pixels.push_back(p);
  }

  void add_node_at(Pixel first) {
    const int degree = std::popcount(joined(first));
    const std::uint32_t begin = number(graph_.node_pixels.size());
    graph_.nodes.push_back({NodeKind::junction, begin, 0});
    add_node_pixel(first);
    if (degree > 1) {
      add_rest_of_junction(first);
    } else {
      graph_.nodes.back().kind = degree == 0 ? NodeKind::isolated : NodeKind::end;
    }
    graph_.nodes.back().pixel_count = number(graph_.node_pixels.size()) - begin;
  }

  void add_node_pixel(Pixel p) {
    node_at(p) = number(graph_.nodes.size());
    graph_.node_pixels.push_back(p);
  }

  void add_rest_of_junction(Pixel first) {
    std::vector<Pixel>& to_visit = walker_.to_visit_;
    to_visit.assign(1, first);
    while (!to_visit.empty()) {
      const Pixel p = to_visit.back();
      to_visit.pop_back();
      for_directions(joined(p), [&](int direction) {
        const Pixel q = moved(p, direction);
        if (!is_node(q) || node_at(q) != 0 || std::popcount(joined(q)) < 2) return;
        add_node_pixel(q);
        to_visit.push_back(q);
      });
    }
    std::sort(graph_.node_pixels.begin() + graph_.nodes.back().first_pixel,
              graph_.node_pixels.end(),
              [](Pixel a, Pixel b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  }

  void add_edges(std::uint32_t node) {
    const GraphNode of = graph_.nodes[node];
    std::int64_t joints = 1 - static_cast<std::int64_t>(of.pixel_count);
    for (std::uint32_t i = 0; i < of.pixel_count; ++i) {
      const Pixel start = graph_.node_pixels[of.first_pixel + i];
      const unsigned around = window(start);
      if (begins_block(around)) --joints;
      for_directions(kJoined[around],
                     [&](int direction) { joints += add_edge_towards(node, start, direction); });
    }
    const Pixel first = graph_.node_pixels[of.first_pixel];
    for (; joints > 0; --joints) {
      graph_.edges.push_back({node, node, first, first, number(graph_.edge_pixels.size()), 0, {}});
    }
  }

  /// The edge that begins in this direction, unless it is there already. Returns 1 for a pixel of
  /// the same node in one of four directions, so that each pair counts once.
  int add_edge_towards(std::uint32_t node, Pixel start, int direction) {
    const Pixel next = moved(start, direction);
    if (is_line(next)) {
      walk_line(node, start, direction);
    } else if (is_node(next)) {
      const std::uint32_t other = node_at(next) - 1;
      if (other == node) return direction < kDirections / 2 ? 1 : 0;
      if (other > node) walk_line(node, start, direction);
    }
    return 0;
  }

  /// From a node pixel to the next one.
  void walk_line(std::uint32_t node, Pixel start, int direction) {
    const std::uint32_t begin = number(graph_.edge_pixels.size());
    Steps steps;
    add_step(steps, direction);
    Pixel p = moved(start, direction);
    while (is_line(p)) {
      take_line(p);
      direction = direction_on(window(p), direction);
      add_step(steps, direction);
      p = moved(p, direction);
    }
    const std::uint32_t count = number(graph_.edge_pixels.size()) - begin;
    graph_.edges.push_back({node, node_at(p) - 1, start, p, begin, count, steps});
  }

  void add_cycle(Pixel first) {
    graph_.nodes.push_back({NodeKind::cycle, number(graph_.node_pixels.size()), 1});
    add_node_pixel(first);
    take_line(first);
    graph_.edge_pixels.pop_back();  // it is the node's
    walk_line(number(graph_.nodes.size()) - 1, first, std::countr_zero(joined(first)));
  }

  GraphWalker& walker_;
  Graph& graph_;
  ConstBitPlaneView image_;
  ConstBitPlaneView nodes_;
  BitPlaneView lines_;
};

GraphWalker::GraphWalker(Index width, Index height)
    : width_(width),
      node_at_(make_uninitialised<std::uint32_t>(static_cast<std::size_t>(width * height))) {}

Graph& GraphWalker::walk(const ConstBitPlaneView& image, const ConstBitPlaneView& nodes,
                         const BitPlaneView& lines) {
  graph_.nodes.clear();
  graph_.edges.clear();
  graph_.node_pixels.clear();
  graph_.edge_pixels.clear();
  Walk(*this, image, nodes, lines).run();
  return graph_;
}

}  // namespace thinbench::detail
