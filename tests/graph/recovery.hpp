// Whether the graph of a drawing is what was drawn.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "graph/drawing.hpp"
#include "support/made_image.hpp"

namespace thinbench {

// How many graphs the tests draw.
inline constexpr int kGrids = 150;
inline constexpr int kMazes = 150;
inline constexpr int kTrees = 200;
inline constexpr int kCircles = 60;
inline constexpr int kWheels = 160;
inline constexpr int kCrossings = 207;
inline constexpr int kWholeCrossings = 100;
inline constexpr int kStars = 100;
inline constexpr int kCompassStars = 161;
static_assert(kGrids + kMazes + kTrees + kCircles + kWheels + kCrossings + kWholeCrossings +
                  kStars + kCompassStars >=
              1000);

/// Beside more background than the drawing has, so that lines meet the ends of words anywhere.
inline ByteImage placed(const ConstImageView& drawing, Index left) {
  return image_by(left + drawing.width, drawing.height,
                  [&](Index x, Index y) { return x < left ? 0 : drawing.row(y)[x - left]; });
}

/// The true node that a found one is, or else the number of true nodes.
inline std::size_t true_node(const Graph& graph, const GraphNode& found, const Truth& truth,
                             Index left) {
  double x = 0;
  double y = 0;
  for (const Pixel p : graph.pixels_of(found)) {
    x += static_cast<double>(p.x - left) / found.pixel_count;
    y += static_cast<double>(p.y) / found.pixel_count;
  }
  const auto is_found = [&](const TrueNode& node) {
    return node.kind == found.kind && std::hypot(node.x - x, node.y - y) <= node.within + 1e-9;
  };
  const auto at = std::find_if(truth.nodes.begin(), truth.nodes.end(), is_found);
  return static_cast<std::size_t>(at - truth.nodes.begin());
}

/// The nodes of a line and its length.
using Line = std::tuple<std::size_t, std::size_t, double>;

inline Line line_of(std::size_t a, std::size_t b, double length) {
  return {std::min(a, b), std::max(a, b), length};
}

/// Counts the graphs that were drawn and found.
class Recovery {
 public:
  void operator()(const Drawing& drawing) {
    const Truth truth = drawing.truth();
    const Index left = 13 * count_ % 67;
    const Graph graph = skeleton_graph(placed(drawing.image(), left).view());
    ++count_;
    SCOPED_TRACE("drawing " + std::to_string(count_));
    std::vector<std::size_t> names;
    for (const GraphNode& node : graph.nodes) names.push_back(true_node(graph, node, truth, left));
    const std::set<std::size_t> different(names.begin(), names.end());
    ASSERT_EQ(names.size(), truth.nodes.size());
    ASSERT_EQ(different.size(), truth.nodes.size());
    ASSERT_FALSE(different.contains(truth.nodes.size())) << "a node where none was drawn";
    compare_lines(graph, names, truth);
  }

  [[nodiscard]] int count() const { return count_; }

 private:
  /// A length is a + b sqrt(2), which is irrational: equal lengths have equal numbers of straight
  /// and of diagonal steps.
  static void compare_lines(const Graph& graph, const std::vector<std::size_t>& names,
                            const Truth& truth) {
    std::vector<Line> found;
    std::vector<Line> drawn;
    for (const GraphEdge& edge : graph.edges) {
      found.push_back(line_of(names[edge.from], names[edge.to], length_of(edge)));
    }
    for (const TrueEdge& edge : truth.edges) {
      drawn.push_back(line_of(edge.from, edge.to, edge.length()));
    }
    std::sort(found.begin(), found.end());
    std::sort(drawn.begin(), drawn.end());
    ASSERT_EQ(found.size(), drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const auto [a, b, length] = drawn[i];
      ASSERT_EQ(std::pair(std::get<0>(found[i]), std::get<1>(found[i])), std::pair(a, b));
      ASSERT_NEAR(std::get<2>(found[i]), length,
                  1e-9 + truth.nodes[a].within + truth.nodes[b].within);
    }
  }

  int count_ = 0;
};

}  // namespace thinbench
