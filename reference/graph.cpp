#include "graph.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

namespace thinbench::reference {
namespace {

bool before(Pixel a, Pixel b) {
  return std::tie(a.y, a.x) < std::tie(b.y, b.x);
}

struct RasterOrder {
  bool operator()(Pixel a, Pixel b) const { return before(a, b); }
};

using PixelSet = std::set<Pixel, RasterOrder>;
using Pixels = std::vector<Pixel>;

class Builder {
 public:
  explicit Builder(const ConstImageView& image) : image_(image) {
    for (std::int32_t y = 0; y < image.height; ++y) {
      for (std::int32_t x = 0; x < image.width; ++x) {
        if (foreground({x, y})) (is_line({x, y}) ? lines_ : node_pixels_).insert({x, y});
      }
    }
  }

  Graph build() {
    while (!node_pixels_.empty()) add_node();
    for (std::uint32_t node = 0; node < graph_.nodes.size(); ++node) add_edges(node);
    while (!lines_.empty()) add_cycle();
    return graph_;
  }

 private:
  [[nodiscard]] bool foreground(Pixel p) const {
    const bool inside = p.x >= 0 && p.y >= 0 && p.x < image_.width && p.y < image_.height;
    return inside && image_.row(p.y)[p.x] != 0;
  }

  /// The neighbours that are joined to p, clockwise from the east.
  [[nodiscard]] Pixels joined(Pixel p) const {
    constexpr std::array<Pixel, 8> steps = {
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    Pixels found;
    for (const Pixel step : steps) {
      const Pixel q = {p.x + step.x, p.y + step.y};
      const bool is_diagonal = step.x != 0 && step.y != 0;
      const bool has_way_round = foreground({q.x, p.y}) || foreground({p.x, q.y});
      if (foreground(q) && !(is_diagonal && has_way_round)) found.push_back(q);
    }
    return found;
  }

  [[nodiscard]] bool is_block(Pixel top_left) const {
    const auto [x, y] = top_left;
    return foreground({x, y}) && foreground({x + 1, y}) && foreground({x, y + 1}) &&
           foreground({x + 1, y + 1});
  }

  [[nodiscard]] bool is_line(Pixel p) const {
    const bool in_block = is_block(p) || is_block({p.x - 1, p.y}) || is_block({p.x, p.y - 1}) ||
                          is_block({p.x - 1, p.y - 1});
    return joined(p).size() == 2 && !in_block;
  }

  [[nodiscard]] NodeKind kind_of(Pixel p) const {
    const std::size_t degree = joined(p).size();
    if (degree == 0) return NodeKind::isolated;
    return degree == 1 ? NodeKind::end : NodeKind::junction;
  }

  /// The first of the node pixels that are left, and, of a junction, all that are joined to it.
  void add_node() {
    const Pixel first = *node_pixels_.begin();
    const NodeKind kind = kind_of(first);
    PixelSet pixels = {first};
    Pixels to_visit = {first};
    while (!to_visit.empty() && kind == NodeKind::junction) {
      const Pixel p = to_visit.back();
      to_visit.pop_back();
      for (const Pixel q : joined(p)) {
        const bool is_junction = node_pixels_.contains(q) && kind_of(q) == NodeKind::junction;
        if (is_junction && pixels.insert(q).second) to_visit.push_back(q);
      }
    }
    add_node(kind, pixels);
  }

  void add_node(NodeKind kind, const PixelSet& pixels) {
    const auto number = static_cast<std::uint32_t>(graph_.nodes.size());
    graph_.nodes.push_back({kind, static_cast<std::uint32_t>(graph_.node_pixels.size()),
                            static_cast<std::uint32_t>(pixels.size())});
    for (const Pixel p : pixels) {
      graph_.node_pixels.push_back(p);
      node_of_[p] = number;
      node_pixels_.erase(p);
    }
  }

  void add_edges(std::uint32_t node) {
    const GraphNode& of = graph_.nodes[node];
    const Pixels pixels(graph_.node_pixels.begin() + of.first_pixel,
                        graph_.node_pixels.begin() + of.first_pixel + of.pixel_count);
    std::int64_t within = 0;  // pairs of joined pixels, twice
    std::int64_t blocks = 0;
    for (const Pixel start : pixels) {
      blocks += is_block(start) ? 1 : 0;
      for (const Pixel q : joined(start)) {
        if (lines_.contains(q)) {
          walk(node, start, q);
        } else if (node_of_.contains(q)) {
          if (node_of_[q] == node) ++within;
          if (node_of_[q] > node) add_edge(node, start, {}, q);
        }
      }
    }
    const auto joints = static_cast<std::int64_t>(pixels.size()) - 1;
    for (std::int64_t i = 0; i < within / 2 - joints - blocks; ++i) {
      add_edge(node, pixels.front(), {}, pixels.front());
    }
  }

  /// Along a line from node pixel `start` to the next node pixel, by way of line pixel p.
  void walk(std::uint32_t node, Pixel start, Pixel p) {
    Pixels line;
    Pixel previous = start;
    while (!node_of_.contains(p)) {
      line.push_back(p);
      lines_.erase(p);
      const Pixels both = joined(p);
      const Pixel next = both[0] == previous ? both[1] : both[0];
      previous = p;
      p = next;
    }
    add_edge(node, start, line, p);
  }

  void add_cycle() {
    const Pixel first = *lines_.begin();
    lines_.erase(first);
    add_node(NodeKind::cycle, {first});
    walk(node_of_[first], first, joined(first).front());
  }

  void add_edge(std::uint32_t from, Pixel start, const Pixels& line, Pixel stop) {
    GraphEdge edge = {from,
                      node_of_[stop],
                      start,
                      stop,
                      static_cast<std::uint32_t>(graph_.edge_pixels.size()),
                      static_cast<std::uint32_t>(line.size()),
                      {}};
    graph_.edge_pixels.insert(graph_.edge_pixels.end(), line.begin(), line.end());
    Pixel previous = start;
    const auto step_to = [&](Pixel p) {
      const bool is_diagonal = p.x != previous.x && p.y != previous.y;
      if (is_diagonal) {
        ++edge.steps.diagonal;
      } else if (p != previous) {
        ++(p.x == previous.x ? edge.steps.vertical : edge.steps.horizontal);
      }
      previous = p;
    };
    for (const Pixel p : line) step_to(p);
    step_to(stop);
    graph_.edges.push_back(edge);
  }

  ConstImageView image_;
  PixelSet lines_;        // line pixels without an edge yet
  PixelSet node_pixels_;  // node pixels without a node yet
  std::map<Pixel, std::uint32_t, RasterOrder> node_of_;
  Graph graph_;
};

}  // namespace

Graph skeleton_graph(ConstImageView skeleton) {
  return Builder(skeleton).build();
}

}  // namespace thinbench::reference
