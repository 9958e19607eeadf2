// Graphs with more nodes and more lines than 16 bits count.
#include <algorithm>

#include <gtest/gtest.h>

#include "graph.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kMany = 65'536;
constexpr Index kSide = 300;  // grids of so many crossings, or rings

using IsForeground = bool (*)(Index x, Index y);

ByteImage drawn(Index width, Index height, IsForeground is_foreground) {
  return image_by(width, height, [=](Index x, Index y) { return is_foreground(x, y) ? 255 : 0; });
}

std::ptrdiff_t count_of(const Graph& graph, NodeKind kind) {
  return std::count_if(graph.nodes.begin(), graph.nodes.end(),
                       [=](const GraphNode& node) { return node.kind == kind; });
}

Graph graph_of(const ByteImage& image, int threads = 1) {
  const Graph graph = skeleton_graph(image.view(), {.threads = threads});
  EXPECT_TRUE(graph == reference::skeleton_graph(image.view()));
  EXPECT_GT(graph.nodes.size(), kMany);
  EXPECT_GT(graph.edges.size(), kMany);
  return graph;
}

TEST(BigGraphs, of_a_grid_have_a_junction_at_each_crossing_but_the_corners) {
  constexpr Index side = (kSide - 1) * 4 + 1;
  const ByteImage image =
      drawn(side, side, [](Index x, Index y) { return x % 4 == 0 || y % 4 == 0; });
  const Graph graph = graph_of(image, 3);
  EXPECT_EQ(count_of(graph, NodeKind::junction), kSide * kSide - 4);
  EXPECT_EQ(std::ssize(graph.nodes), kSide * kSide - 4);
  EXPECT_EQ(std::ssize(graph.edges), 2 * kSide * (kSide - 1) - 4);  // those round corners are one
}

TEST(BigGraphs, of_combs_have_each_tooth_and_are_pruned_to_lines) {
  constexpr Index last = 1200;
  constexpr Index spines = 200;
  constexpr Index teeth = 597;  // on each side of a spine
  const ByteImage image = drawn(last + 1, 6 * spines, [](Index x, Index y) {
    return y % 6 == 2 || (x % 2 == 0 && x >= 4 && x <= last - 4 && y % 6 < 5);
  });
  const Graph graph = graph_of(image);
  EXPECT_EQ(count_of(graph, NodeKind::junction), spines * teeth);
  EXPECT_EQ(count_of(graph, NodeKind::end), spines * (2 * teeth + 2));
  EXPECT_EQ(std::ssize(graph.edges), spines * (2 * teeth + teeth + 1));
  const ByteImage lines = drawn(last + 1, 6 * spines, [](Index, Index y) { return y % 6 == 2; });
  ByteImage result(image.width(), image.height());
  const Graph pruned = prune(image.view(), result.view(), {.min_length = 2.5});
  EXPECT_TRUE(equal(result.view(), lines.view()));
  EXPECT_TRUE(pruned == reference::skeleton_graph(lines.view()));
}

TEST(BigGraphs, of_rings_have_each_cycle) {
  const ByteImage image = drawn(4 * kSide, 4 * kSide, [](Index x, Index y) {
    return x % 4 < 3 && y % 4 < 3 && (x % 4 + y % 4) % 2 == 1;
  });
  const Graph graph = graph_of(image);
  EXPECT_EQ(count_of(graph, NodeKind::cycle), kSide * kSide);
  EXPECT_EQ(std::ssize(graph.edges), kSide * kSide);
}

}  // namespace
}  // namespace thinbench
