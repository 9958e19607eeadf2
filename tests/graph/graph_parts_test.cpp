// What is made of graphs, and the graphs of labels.
#include "thinbench/graph_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graph/label_loop.hpp"
#include "support/made_image.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/graph_paths.hpp"

namespace thinbench {
namespace {

using Numbers = std::vector<std::uint32_t>;
using enum NodeKind;

// A cross with a square on its right.
const TextImage kDrawn = {"..#......",  //
                          "..#..###.",  //
                          "######.#.",  //
                          "..#..###.",  //
                          "..#......"};

Graph graph_of(const TextImage& lines) {
  return skeleton_graph(image_of(lines).view());
}

double total_length(const Graph& graph) {
  double sum = 0;
  for (const GraphEdge& edge : graph.edges) sum += length_of(edge);
  return sum;
}

TEST(Subgraph, has_the_edges_in_the_order_given_and_their_nodes_alone) {
  const Graph line = graph_of({"##.###.#"});
  ASSERT_EQ(line.edges.size(), 2U);
  const Graph second = subgraph(line, Numbers{1});
  ASSERT_EQ(second.nodes.size(), 2U);
  EXPECT_EQ(second.edges[0], (GraphEdge{0, 1, {3, 0}, {5, 0}, 0, 1, {2, 0, 0}}));
  EXPECT_EQ(second.edge_pixels, (std::vector<Pixel>{{4, 0}}));
  const Graph swapped = subgraph(line, Numbers{1, 0});
  EXPECT_EQ(swapped.edges[0].start, (Pixel{3, 0}));
  EXPECT_EQ(swapped.edges[1].start, (Pixel{0, 0}));
  EXPECT_EQ(subgraph(line, {}), Graph{});
}

TEST(SplitAt, makes_two_edges_of_one_that_end_in_the_pixel) {
  const std::vector<Pixel> pixels = {{2, 1}};
  const Graph split = split_graph(graph_of({"#....",  //
                                            ".###.",  //
                                            "....#"}),
                                  pixels);
  ASSERT_EQ(split.nodes.size(), 3U);
  EXPECT_EQ(split.nodes[2], (GraphNode{given, 2, 1}));
  EXPECT_EQ(split.node_pixels[2], (Pixel{2, 1}));
  ASSERT_EQ(split.edges.size(), 2U);
  EXPECT_EQ(split.edges[0], (GraphEdge{0, 2, {0, 0}, {2, 1}, 0, 1, {1, 0, 1}}));
  EXPECT_EQ(split.edges[1], (GraphEdge{1, 2, {4, 2}, {2, 1}, 1, 1, {1, 0, 1}}));
  EXPECT_EQ(split.edge_pixels, (std::vector<Pixel>{{1, 1}, {3, 1}}));
}

TEST(SplitAt, pixels_of_nodes_change_nothing) {
  const Graph graph = graph_of(kDrawn);
  EXPECT_EQ(split_graph(graph, std::vector<Pixel>{{2, 0}, {0, 2}}), graph);
}

TEST(SplitAt, keeps_every_pixel_and_the_length) {
  std::mt19937 random(4);
  const Graph graph = graph_of(kDrawn);
  for (int i = 0; i < 100; ++i) {
    std::vector<Pixel> pixels;
    for (int n = 0; n < 4; ++n)
      pixels.push_back(graph.edge_pixels[random() % graph.edge_pixels.size()]);
    const Graph split = split_graph(graph, pixels);
    EXPECT_EQ(split.node_pixels.size() + split.edge_pixels.size(),
              graph.node_pixels.size() + graph.edge_pixels.size());
    EXPECT_EQ(split.edges.size() - graph.edges.size(), split.nodes.size() - graph.nodes.size());
    EXPECT_NEAR(total_length(split), total_length(graph), 1e-12);
    for (const GraphEdge& edge : split.edges) EXPECT_LE(edge.from, edge.to);
  }
}

TEST(OpenCycles, removes_the_closing_edges_of_short_cycles_alone) {
  const Graph graph = graph_of(kDrawn);
  const auto nodes = static_cast<std::uint32_t>(graph.nodes.size());
  const auto found = cycles(nodes, links_of(graph));
  ASSERT_EQ(found.size(), 1U);
  const double length = found[0].length;
  EXPECT_EQ(open_cycles(graph, length - 0.01), graph);
  const Graph open = open_cycles(graph, length);
  EXPECT_EQ(open.nodes, graph.nodes);
  EXPECT_EQ(open.edges.size(), graph.edges.size() - 1);
  EXPECT_TRUE(cycles(nodes, links_of(open)).empty());
  EXPECT_EQ(open_cycles(graph), open);
  const Spacing ten = {.x = 10, .y = 10};
  EXPECT_EQ(open_cycles(graph, 10 * length - 0.01, ten), graph);
  EXPECT_EQ(open_cycles(graph, 10 * length + 0.01, ten), open);
}

TEST(NearestPlace, is_the_first_of_the_nearest_pixels) {
  const Graph graph = graph_of({"#####"});
  EXPECT_EQ(nearest_place(graph, 1.9, 3), (GraphPlace{0, {2, 0}, std::hypot(0.1, 3)}));
  EXPECT_EQ(nearest_place(graph, 1.5, 0), (GraphPlace{0, {1, 0}, 0.5}));
  EXPECT_EQ(nearest_place(graph, 9, 0, {.x = 2, .y = 1}), (GraphPlace{0, {4, 0}, 10}));
}

TEST(NearestPlace, is_the_first_pixel_where_distances_overflow) {
  EXPECT_EQ(nearest_place(graph_of({".....", "#####"}), 1e290, 0, {.x = 1e30, .y = 1}),
            (GraphPlace{0, {0, 1}, INFINITY}));
}

TEST(Summary, tells_edges_by_what_they_lead_between) {
  const std::vector<EdgeSummary> rows = summary(graph_of({"###.....",  //
                                                          "........",  //
                                                          "..#..##.",  //
                                                          "..#.#..#",  //
                                                          "##...##.",  //
                                                          "..#....."}));
  Numbers counts(4);
  for (const EdgeSummary& row : rows) ++counts[static_cast<std::size_t>(row.type)];
  EXPECT_EQ(rows[0].type, EdgeType::end_end);
  EXPECT_EQ(rows[0].length, 2);
  EXPECT_EQ(rows[0].tortuosity, 1);
  EXPECT_EQ(counts[static_cast<std::size_t>(EdgeType::cycle)], 1U);
  const EdgeSummary& cycle = rows.back();
  EXPECT_EQ(cycle.type, EdgeType::cycle);
  EXPECT_DOUBLE_EQ(cycle.length, 2 + 4 * std::numbers::sqrt2);
  EXPECT_EQ(cycle.chord, 0);
  EXPECT_TRUE(std::isnan(cycle.tortuosity));
}

std::vector<std::string> labels_text(const Graph& graph, Index width, Index height) {
  std::vector<std::int32_t> labels(static_cast<std::size_t>(width * height), 77);
  edge_labels(graph, {labels.data(), width, height});
  std::vector<std::string> lines;
  for (Index y = 0; y < height; ++y) {
    lines.emplace_back();
    for (Index x = 0; x < width; ++x) {
      const auto label = static_cast<std::size_t>(labels[static_cast<std::size_t>(y * width + x)]);
      lines.back() += ".123456789?"[std::min<std::size_t>(label, 10)];
    }
  }
  return lines;
}

TEST(EdgeLabels, tell_lines_apart_that_meet_at_a_junction) {
  const TextImage tee = {"###.",  //
                         ".#..",  //
                         ".#.#"};
  EXPECT_EQ(labels_text(graph_of(tee), 4, 3), (TextImage{"1.2.",  //
                                                         ".3..",  //
                                                         ".3.."}));
  const TextImage ring = {".#.",  //
                          "#.#",  //
                          ".#."};
  EXPECT_EQ(labels_text(graph_of(ring), 3, 3), (TextImage{".1.",  //
                                                          "1.1",  //
                                                          ".1."}));
}

TEST(EdgeLabels, of_a_drawing_are_those_of_its_pixels) {
  const Graph graph = graph_of(kDrawn);
  const std::vector<std::string> labels = labels_text(graph, 9, 5);
  for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
    for (const auto [x, y] : graph.pixels_of(graph.edges[edge])) {
      EXPECT_EQ(labels[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)],
                static_cast<char>('1' + edge));
    }
  }
}

TEST(Summary, chords_and_lengths_are_in_the_unit_of_the_spacing) {
  const std::vector<EdgeSummary> rows = summary(graph_of({"##.",  //
                                                          "..#"}),
                                                {.x = 3, .y = 4});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(rows[0].length, 3 + 5);
  EXPECT_DOUBLE_EQ(rows[0].chord, std::hypot(6, 4));
}

TEST(Summary, chords_of_pixels_that_are_far_apart_do_not_overflow) {
  constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();
  const Graph graph = {{{NodeKind::end, 0, 1}, {NodeKind::end, 1, 1}},
                       {{0, 1, {-far, 0}, {far, 0}, 0, 0, {}}},
                       {{-far, 0}, {far, 0}},
                       {}};
  EXPECT_DOUBLE_EQ(summary(graph).at(0).chord, 2.0 * far);
}

TEST(GraphOfLabels, equals_a_loop_over_the_labels) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const LabelImage image = random_labels(random);
    ASSERT_TRUE(graph_of_labels(image.view()) == graph_of_each_label(image)) << "image " << i;
  }
}

TEST(GraphOfLabels, of_an_image_without_pixels_or_labels_is_empty) {
  const LabelImage background = labels_of({"...", "..."});
  EXPECT_TRUE(graph_of_labels(background.view()) == LabelGraph{});
  EXPECT_TRUE(graph_of_labels({nullptr, 0, 5}) == LabelGraph{});
  EXPECT_TRUE(graph_of_labels({nullptr, 5, 0}) == LabelGraph{});
}

TEST(LabelDistances, equal_a_loop_over_the_labels) {
  std::mt19937 random(2);
  const Spacing spacing = {.x = 2, .y = 0.5};
  for (int i = 0; i < 200; ++i) {
    const LabelImage image = random_labels(random);
    const std::size_t pixels = image.labels.size();
    std::vector<double> found(pixels), of_label(pixels), expected(pixels);
    distances_of_labels(image.view(), {found.data(), image.width, image.height}, spacing);
    for_each_label(image, [&](std::int32_t label, const ByteImage& mask) {
      distances(mask.view(), {of_label.data(), image.width, image.height}, spacing);
      for (std::size_t at = 0; at < pixels; ++at) {
        if (image.labels[at] == label) expected[at] = of_label[at];
      }
    });
    ASSERT_EQ(found, expected) << "image " << i;
  }
}

TEST(PruneLabels, equals_a_loop_over_the_labels) {
  std::mt19937 random(3);
  const Pruning pruning = {.min_length = 3, .removes_components = true};
  for (int i = 0; i < 200; ++i) {
    LabelImage image = random_labels(random);
    LabelGraph expected;
    std::vector<std::int32_t> left(image.labels.size());
    for_each_label(image, [&](std::int32_t label, ByteImage mask) {
      append(expected, label, prune(mask.view(), mask.view(), pruning));
      for (std::size_t at = 0; at < left.size(); ++at) {
        const Index x = static_cast<Index>(at) % image.width;
        if (mask.at(x, static_cast<Index>(at) / image.width) != 0) left[at] = label;
      }
    });
    ASSERT_TRUE(prune_labels(image.view(), image.view(), pruning) == expected) << "image " << i;
    ASSERT_EQ(image.labels, left) << "image " << i;
  }
}

}  // namespace
}  // namespace thinbench
