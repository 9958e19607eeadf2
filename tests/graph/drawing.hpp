// Drawings of graphs, one pixel thin, of which nodes, edges and lengths are known from what was
// drawn; nothing of the library is used to find them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "thinbench/graph.hpp"

namespace thinbench {

struct TrueNode {
  NodeKind kind;
  Pixel at;
};

struct TrueEdge {
  Pixel from;
  Pixel to;
  int straight;
  int diagonal;
  Pixel first;  // in raster order, ends included
};

struct Truth {
  std::vector<TrueNode> nodes;
  std::vector<TrueEdge> edges;
};

using Path = std::vector<Pixel>;
using Place = std::pair<std::int32_t, std::int32_t>;  // y, x

/// Places are in raster order.
inline Place place_of(Pixel p) {
  return {p.y, p.x};
}

inline int across(Pixel a, Pixel b) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

/// The line from a to b: one pixel for each step of the longer side, the nearest to the true line.
inline Path line_between(Pixel a, Pixel b) {
  const int steps = across(a, b);
  Path path = {a};
  for (int i = 1; i <= steps; ++i) {
    const auto between = [&](int from, int to) {
      const double exact = from + (to - from) * static_cast<double>(i) / steps;
      return static_cast<std::int32_t>(std::floor(exact + 0.5));
    };
    path.push_back({between(a.x, b.x), between(a.y, b.y)});
  }
  return path;
}

inline Pixel first_of(const Path& path) {
  return *std::min_element(path.begin(), path.end(),
                           [](Pixel a, Pixel b) { return place_of(a) < place_of(b); });
}

/// Points and lines between them. Where a point has two lines it is a bend; what it is otherwise
/// follows from their number.
class Drawing {
 public:
  Drawing(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width * height)),
        linked_(pixels_.size()),
        is_point_(pixels_.size()) {}

  void point(Pixel p) {
    if (is_point_[place(p)]) return;
    if (is_drawn(p)) overlaps_ = true;
    points_.push_back(p);
    is_point_[place(p)] = true;
    pixels_[place(p)] = 255;
  }

  /// Only its ends are points; it may not pass others.
  void line(Pixel a, Pixel b) { add(line_between(a, b)); }

  /// Every pixel of the path is a point, so that other lines may meet it anywhere.
  void path(const Path& pixels) {
    for (std::size_t i = 1; i < pixels.size(); ++i) add({pixels[i - 1], pixels[i]});
  }

  /// Whether the raster holds the drawing: pixels are joined if and only if they were drawn one
  /// after the other. Then the graph of the image must be that of the drawing, with every length
  /// exact.
  [[nodiscard]] bool is_held() const {
    for (std::int32_t y = 0; y < height_; ++y) {
      for (std::int32_t x = 0; x < width_; ++x) {
        if (is_drawn({x, y}) && !holds({x, y})) return false;
      }
    }
    return !overlaps_;
  }

  [[nodiscard]] ConstImageView image() const { return {pixels_.data(), width_, height_}; }
  [[nodiscard]] std::size_t points() const { return points_.size(); }

  /// Points become nodes, but for bends: their two lines become one, or a cycle.
  [[nodiscard]] Truth truth() const {
    Truth truth = {{}, edges_};
    for (const Pixel p : points_) {
      const auto lines = lines_of(truth, p);
      if (lines == 0) truth.nodes.push_back({NodeKind::isolated, p});
      if (lines == 1) truth.nodes.push_back({NodeKind::end, p});
      if (lines == 2) straighten(truth, p);
      if (lines > 2) truth.nodes.push_back({NodeKind::junction, p});
    }
    return truth;
  }

 private:
  static constexpr std::array<Pixel, 8> kSteps = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

  static Pixel moved(Pixel p, unsigned direction) {
    const Pixel step = kSteps[direction % 8];
    return {p.x + step.x, p.y + step.y};
  }

  [[nodiscard]] std::size_t place(Pixel p) const {
    return static_cast<std::size_t>(p.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(p.x);
  }

  [[nodiscard]] bool is_drawn(Pixel p) const {
    const bool is_inside = p.x >= 0 && p.y >= 0 && p.x < width_ && p.y < height_;
    return is_inside && pixels_[place(p)] != 0;
  }

  void add(const Path& path) {
    point(path.front());
    point(path.back());
    TrueEdge edge = {path.front(), path.back(), 0, 0, first_of(path)};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Pixel p = path[i];
      const bool is_diagonal = p.x != path[i - 1].x && p.y != path[i - 1].y;
      ++(is_diagonal ? edge.diagonal : edge.straight);
      if (i + 1 < path.size() && is_drawn(p)) overlaps_ = true;
      pixels_[place(p)] = 255;
      link(path[i - 1], p);
    }
    edges_.push_back(edge);
  }

  void link(Pixel a, Pixel b) {
    for (unsigned d = 0; d < 8; ++d) {
      if (moved(a, d) != b) continue;
      if (are_linked(a, d)) overlaps_ = true;
      linked_[place(a)] |= static_cast<std::uint8_t>(1U << d);
      linked_[place(b)] |= static_cast<std::uint8_t>(1U << (d + 4) % 8);
    }
  }

  [[nodiscard]] bool are_linked(Pixel p, unsigned d) const {
    return (linked_[place(p)] >> d % 8 & 1) != 0;
  }

  /// Of a pixel and its neighbours.
  [[nodiscard]] bool holds(Pixel p) const {
    for (unsigned d = 0; d < 8; ++d) {
      const Pixel q = moved(p, d);
      if (!is_drawn(q)) continue;
      const bool has_way_round = is_drawn(moved(p, d + 1)) || is_drawn(moved(p, d + 7));
      const bool is_joined = d % 2 == 0 || !has_way_round;
      if (is_joined != are_linked(p, d)) return false;
    }
    return true;
  }

  static std::ptrdiff_t lines_of(const Truth& truth, Pixel point) {
    std::ptrdiff_t lines = 0;
    for (const TrueEdge& edge : truth.edges) {
      lines += (edge.from == point ? 1 : 0) + (edge.to == point ? 1 : 0);
    }
    return lines;
  }

  /// Makes one line of the two at a bend. If these are one already it is a cycle, whose node is the
  /// first pixel.
  static void straighten(Truth& truth, Pixel bend) {
    const auto ends_here = [=](const TrueEdge& edge) {
      return edge.from == bend || edge.to == bend;
    };
    const auto one = std::find_if(truth.edges.begin(), truth.edges.end(), ends_here);
    if (one->from == one->to) {
      truth.nodes.push_back({NodeKind::cycle, one->first});
      one->from = one->to = one->first;
      return;
    }
    const auto other = std::find_if(one + 1, truth.edges.end(), ends_here);
    const auto far = [=](const TrueEdge& edge) { return edge.from == bend ? edge.to : edge.from; };
    *one = {far(*one), far(*other), one->straight + other->straight,
            one->diagonal + other->diagonal, first_of({one->first, other->first})};
    truth.edges.erase(other);
  }

  int width_;
  int height_;
  std::vector<std::uint8_t> pixels_;
  std::vector<std::uint8_t> linked_;  // bit d: drawn before or after the neighbour in direction d
  std::vector<bool> is_point_;
  std::vector<Pixel> points_;
  std::vector<TrueEdge> edges_;
  bool overlaps_ = false;  // a line runs over another one
};

}  // namespace thinbench
