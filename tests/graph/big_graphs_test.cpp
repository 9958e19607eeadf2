// Graphs with more nodes and more lines than 16 bits count.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/made_image.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kMany = 65'536;

ByteImage drawn(std::int32_t width, std::int32_t height, bool (*is_foreground)(Pixel)) {
  return image_by(width, height, [=](Index x, Index y) {
    return is_foreground({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}) ? 255 : 0;
  });
}

std::ptrdiff_t count_of(const Graph& graph, NodeKind kind) {
  return std::count_if(graph.nodes.begin(), graph.nodes.end(),
                       [=](const GraphNode& node) { return node.kind == kind; });
}

// Lines of a grid: its corners are bends, all other crossings are junctions.
constexpr std::int32_t kLast = 299;
constexpr std::int32_t kSpacing = 4;

bool is_corner(Pixel crossing) {
  return crossing.x % kLast == 0 && crossing.y % kLast == 0;
}

std::vector<Pixel> junctions() {
  std::vector<Pixel> found;
  for (std::int32_t y = 0; y <= kLast; ++y) {
    for (std::int32_t x = 0; x <= kLast; ++x) {
      if (!is_corner({x, y})) found.push_back({x, y});
    }
  }
  return found;
}

/// The junctions to which the lines from a junction to later ones lead, clockwise from the east.
std::vector<Pixel> later_neighbours(Pixel p) {
  if (p == Pixel{1, 0}) return {{2, 0}, {1, 1}, {0, 1}};
  std::vector<Pixel> found;
  if (p.x < kLast)
    found.push_back(p.x == kLast - 1 && p.y == 0 ? Pixel{kLast, 1} : Pixel{p.x + 1, p.y});
  if (p.y < kLast) found.push_back({p.x, p.y + 1});
  if (found.empty() || !is_corner(found.back())) return found;
  if (p.y == kLast)
    found.pop_back();  // the line round this corner is of the column above it
  else
    found.back() = {p.x == 0 ? 1 : kLast - 1, kLast};
  return found;
}

TEST(BigGraphs, of_a_grid_have_each_crossing_and_each_line) {
  const std::int32_t side = kLast * kSpacing + 1;
  const ByteImage image =
      drawn(side, side, [](Pixel p) { return p.x % kSpacing == 0 || p.y % kSpacing == 0; });
  const Graph graph = skeleton_graph(image.view(), {.threads = 3});
  std::vector<Pixel> nodes;
  std::vector<std::pair<Pixel, Pixel>> lines;
  for (const Pixel p : junctions()) {
    nodes.push_back({p.x * kSpacing, p.y * kSpacing});
    for (const Pixel q : later_neighbours(p)) {
      lines.push_back({nodes.back(), {q.x * kSpacing, q.y * kSpacing}});
    }
  }
  ASSERT_GT(nodes.size(), kMany);
  EXPECT_EQ(graph.node_pixels, nodes);
  EXPECT_EQ(count_of(graph, NodeKind::junction), std::ssize(nodes));
  ASSERT_EQ(graph.edges.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const GraphEdge& edge = graph.edges[i];
    ASSERT_EQ(std::pair(edge.start, edge.stop), lines[i]);
    ASSERT_EQ(nodes[edge.from], edge.start);
    ASSERT_EQ(nodes[edge.to], edge.stop);
    ASSERT_EQ(length_of(edge), std::abs(edge.start.x - edge.stop.x) + edge.stop.y - edge.start.y);
  }
}

TEST(BigGraphs, of_combs_have_each_tooth_and_are_pruned_to_lines) {
  constexpr std::int32_t last = 1200;
  constexpr std::int32_t spines = 200;
  constexpr std::int32_t teeth = 597;  // on each side of a spine
  const ByteImage image = drawn(last + 1, 6 * spines, [](Pixel p) {
    const bool is_spine = p.y % 6 == 2;
    const bool is_tooth = p.x % 2 == 0 && p.x >= 4 && p.x <= last - 4 && p.y % 6 < 5;
    return is_spine || is_tooth;
  });
  const Graph graph = skeleton_graph(image.view());
  EXPECT_EQ(count_of(graph, NodeKind::junction), spines * teeth);
  EXPECT_EQ(count_of(graph, NodeKind::end), spines * (2 * teeth + 2));
  ASSERT_EQ(graph.edges.size(), std::size_t{spines * (2 * teeth + teeth + 1)});
  ASSERT_GT(graph.edges.size(), kMany);

  ByteImage result(image.width(), image.height());
  const Graph pruned = prune(image.view(), result.view(), {.min_length = 2.5});
  const ByteImage lines = drawn(last + 1, 6 * spines, [](Pixel p) { return p.y % 6 == 2; });
  EXPECT_TRUE(equal(result.view(), lines.view()));
  ASSERT_EQ(pruned.edges.size(), std::size_t{spines});
  EXPECT_EQ(pruned.edges.back(), (GraphEdge{2 * spines - 2,
                                            2 * spines - 1,
                                            {0, 6 * spines - 4},
                                            {last, 6 * spines - 4},
                                            (spines - 1) * (last - 1),
                                            last - 1,
                                            {last, 0, 0}}));
}

TEST(BigGraphs, of_rings_have_each_cycle) {
  constexpr std::int32_t rings = 300;
  const ByteImage image = drawn(4 * rings, 4 * rings, [](Pixel p) {
    return p.x % 4 < 3 && p.y % 4 < 3 && (p.x % 4 + p.y % 4) % 2 == 1;
  });
  const Graph graph = skeleton_graph(image.view());
  ASSERT_GT(graph.nodes.size(), kMany);
  EXPECT_EQ(count_of(graph, NodeKind::cycle), rings * rings);
  ASSERT_EQ(graph.edges.size(), std::size_t{rings * rings});
  for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
    const auto x = static_cast<std::int32_t>(4 * (i % rings) + 1);
    const auto y = static_cast<std::int32_t>(4 * (i / rings));
    ASSERT_EQ(graph.edges[i], (GraphEdge{i, i, {x, y}, {x, y}, 3 * i, 3, {0, 0, 4}}));
  }
}

}  // namespace
}  // namespace thinbench
