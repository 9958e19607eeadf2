#include "thinbench/graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graph.hpp"
#include "support/made_image.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using Kinds = std::vector<NodeKind>;
using enum NodeKind;

Kinds kinds_of(const Graph& graph) {
  Kinds kinds;
  for (const GraphNode& node : graph.nodes) kinds.push_back(node.kind);
  return kinds;
}

Graph graph_of(const TextImage& lines) {
  const ByteImage image = image_of(lines);
  const Graph graph = skeleton_graph(image.view());
  EXPECT_TRUE(graph == reference::skeleton_graph(image.view()));
  return graph;
}

ByteImage random_image(std::mt19937& random) {
  const auto width = 1 + static_cast<Index>(random() % 80);
  const auto height = 1 + static_cast<Index>(random() % 12);
  const auto rarity = static_cast<unsigned>(2 + random() % 6);
  return image_by(width, height, [&](Index, Index) { return random() % rarity == 0 ? 255 : 0; });
}

TEST(SkeletonGraph, lengths_are_in_the_unit_of_the_spacing) {
  const Graph graph = graph_of({"##...",  //
                                "..#..",  //
                                "..#..",  //
                                "..###"});
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.edges[0].steps, (Steps{3, 2, 1}));
  EXPECT_DOUBLE_EQ(length_of(graph.edges[0], {.x = 3, .y = 4}), 3 * 3 + 2 * 4 + 5);
}

TEST(SkeletonGraph, has_the_nodes_and_the_number_of_edges_that_a_person_sees) {
  struct Case {
    const char* what;
    TextImage image;
    Kinds nodes;
    std::size_t edges;
  };
  for (const auto& [what, image, nodes, edges] : std::vector<Case>{
           {"a corner is no junction", {"##.", ".##", "..#"}, {end, end}, 1},
           {"joined junction pixels are one node",
            {"#...#", ".#.#.", "..#..", "..#..", ".#.#.", "#...#"},
            {end, end, junction, end, end},
            4},
           {"single pixels and closed lines", {".#....", "#.#..#", ".#...."}, {isolated, cycle}, 1},
           {"parallel edges",
            {"...##...", "###..###", "...##..."},
            {end, junction, junction, end},
            4},
           {"a loop", {"....##.", "####..#", "....##."}, {end, junction}, 2},
           {"a hole within a junction is a loop without pixels",
            {"..#..", "..#..", "##.##", "..#..", "..#.."},
            {end, junction, end, end, end},
            5},
           {"a full block is a junction", {"##..", "####"}, {junction, end}, 1}}) {
    const Graph graph = graph_of(image);
    EXPECT_EQ(kinds_of(graph), nodes) << what;
    EXPECT_EQ(graph.edges.size(), edges) << what;
  }
}

TEST(ClassifyPixels, follows_the_definition_of_degrees) {
  const ByteImage image = image_of({"#.###..",  //
                                    "....#.#",  //
                                    "##..###",  //
                                    "##....#"});
  ByteImage classes(7, 4), degrees(7, 4);
  classify_pixels(image.view(), classes.view(), degrees.view());
  const auto lines = [](const ByteImage& values) {
    TextImage text(4);
    for (Index y = 0; y < 4; ++y) {
      for (Index x = 0; x < 7; ++x)
        text[static_cast<std::size_t>(y)] += char('0' + values.at(x, y));
    }
    return text;
  };
  EXPECT_EQ(lines(classes), (TextImage{"1023300",  //
                                       "0000302",  //
                                       "4400334",  //
                                       "4400002"}));
  EXPECT_EQ(lines(degrees), (TextImage{"0012200",  //
                                       "0000201",  //
                                       "2200223",  //
                                       "2200001"}));
}

TEST(ClassifyPixels, counts_four_neighbours) {
  for (const TextImage& crossing : {TextImage{".#.", "###", ".#."}, {"#.#", ".#.", "#.#"}}) {
    ByteImage degrees(3, 3);
    classify_pixels(image_of(crossing).view(), {}, degrees.view());
    EXPECT_EQ(degrees.at(1, 1), 4);
  }
}

TEST(ClassifyPixels, leaves_gaps_between_rows_alone) {
  const ByteImage image(70, 2);
  std::vector<std::uint8_t> bytes(std::size_t{2 * 150}, 77);
  classify_pixels(image.view(), {bytes.data(), 70, 2, 150}, {});
  const std::vector<std::uint8_t> of_row(70, 0);
  const std::vector<std::uint8_t> gap(80, 77);
  for (const std::ptrdiff_t row : {0, 150}) {
    EXPECT_TRUE(std::equal(of_row.begin(), of_row.end(), bytes.begin() + row));
    EXPECT_TRUE(std::equal(gap.begin(), gap.end(), bytes.begin() + row + 70));
  }
}

TEST(FullBlocks, are_counted_and_the_first_is_named) {
  ByteImage image(130, 3);
  EXPECT_EQ(full_blocks(image.view()), FullBlocks{});
  for (const Index x : {63, 64, 65, 129}) image.at(x, 1) = image.at(x, 2) = 1;
  EXPECT_EQ(full_blocks(image.view()), (FullBlocks{2, {63, 1}}));
  EXPECT_EQ(full_blocks({nullptr, 0, 5}), FullBlocks{});
}

TEST(SkeletonGraph, of_empty_images_is_empty) {
  EXPECT_EQ(skeleton_graph({nullptr, 0, 5}), Graph{});
  EXPECT_EQ(skeleton_graph({nullptr, 5, 0}), Graph{});
  constexpr Index highest = Index{1} << 29;
  EXPECT_EQ(skeleton_graph({nullptr, 0, highest}), Graph{});
  EXPECT_EQ(prune({nullptr, 0, highest}, {nullptr, 0, highest}, {.min_length = 2}), Graph{});
  EXPECT_EQ(graph_of({"...", "..."}), Graph{});
}

/// The class of each pixel that the nodes and edges say.
ByteImage classes_by(const Graph& graph, const ByteImage& image) {
  constexpr std::array<std::uint8_t, 4> class_of_kind = {1, 2, 4, 3};
  ByteImage classes(image.width(), image.height());
  for (const Pixel p : graph.edge_pixels) classes.at(p.x, p.y) = 3;
  for (const GraphNode& node : graph.nodes) {
    for (const Pixel p : graph.pixels_of(node)) {
      classes.at(p.x, p.y) = class_of_kind[static_cast<std::size_t>(node.kind)];
    }
  }
  return classes;
}

TEST(SkeletonGraph, has_every_pixel_once_its_class_and_the_euler_number_on_20000_random_images) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const ByteImage image = random_image(random);
    const Graph graph = skeleton_graph(image.view());
    ASSERT_TRUE(graph == reference::skeleton_graph(image.view()));
    ByteImage classes(image.width(), image.height());
    classify_pixels(image.view(), classes.view(), {});
    ASSERT_TRUE(equal(classes.view(), classes_by(graph, image).view()));
    ASSERT_EQ(std::ssize(graph.node_pixels) + std::ssize(graph.edge_pixels),
              count_foreground(image));
    ASSERT_EQ(std::ssize(graph.nodes) - std::ssize(graph.edges), euler_number(image.view()));
  }
}

ByteImage pruned(const TextImage& lines, const Pruning& pruning) {
  ByteImage image = image_of(lines);
  const Graph graph = prune(image.view(), image.view(), pruning);
  EXPECT_EQ(graph, skeleton_graph(image.view()));
  return image;
}

const TextImage kSpurs = {"....#.......",  //
                          "....#....#..",  //
                          "############",  //
                          "............",  //
                          "#......##..."};

TEST(Prune, removes_branches_below_the_length) {
  EXPECT_EQ(text_of(pruned(kSpurs, {.min_length = 2})), (TextImage{"....#.......",  //
                                                                   "....#.......",  //
                                                                   "############",  //
                                                                   "............",  //
                                                                   "#......##..."}));
  EXPECT_EQ(text_of(pruned(kSpurs, {.min_length = 3})), (TextImage{"............",  //
                                                                   "............",  //
                                                                   "############",  //
                                                                   "............",  //
                                                                   "#......##..."}));
}

/// With more ends and junctions than 16 bits number.
TEST(Prune, of_combs_leaves_lines) {
  constexpr Index width = 1201, height = 1200;
  const ByteImage combs = image_by(width, height, [](Index x, Index y) {
    const bool is_tooth = x % 2 == 0 && x >= 4 && x < width - 4 && y % 6 < 5;
    return y % 6 == 2 || is_tooth ? 255 : 0;
  });
  const ByteImage lines =
      image_by(width, height, [](Index, Index y) { return y % 6 == 2 ? 255 : 0; });
  EXPECT_GT(skeleton_graph(combs.view()).nodes.size(), 65536U);
  ByteImage result(width, height);
  const Graph pruned = prune(combs.view(), result.view(), {.min_length = 2.5});
  EXPECT_TRUE(equal(result.view(), lines.view()));
  EXPECT_TRUE(pruned == reference::skeleton_graph(lines.view()));
}

TEST(Prune, keeps_components_and_holes) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const ByteImage image = random_image(random);
    ByteImage result(image.width(), image.height());
    const Graph graph = prune(image.view(), result.view(), {.min_length = 1.0 + i % 7});
    ASSERT_EQ(graph, skeleton_graph(result.view()));
    ASSERT_EQ(euler_number(image.view()), euler_number(result.view()));
    ASSERT_EQ(find_objects(image.view()).size(), find_objects(result.view()).size());
  }
}

TEST(Prune, equals_the_plain_method) {
  std::mt19937 random(4);
  constexpr std::array<double, 5> lengths = {0, 1, 2.5, 6, 100};
  constexpr std::array<double, 4> widths = {0, 0, 0.6, 3};
  constexpr std::array<Spacing, 4> spacings = {{{1, 1}, {1, 1}, {0.7, 0.7}, {0.5, 3}}};
  for (int i = 0; i < 3000; ++i) {
    ByteImage image = random_image(random);
    const Spacing spacing = spacings[random() % 4];
    std::vector<double> numbers(static_cast<std::size_t>(image.width() * image.height()));
    const View<double> of_image = {numbers.data(), image.width(), image.height()};
    distances(image.view(), of_image, spacing);
    if (i % 2 == 0) thin(Rule::guo_hall, image.view(), image.view());
    Pruning pruning = {.min_length = lengths[random() % 5], .min_widths = widths[random() % 4]};
    pruning.distances = of_image;
    pruning.spacing = spacing;
    pruning.removes_components = i % 3 == 0;
    ByteImage expected(image.width(), image.height());
    ByteImage result(image.width(), image.height());
    reference::prune(image.view(), expected.view(), pruning);
    prune(image.view(), result.view(), pruning);
    ASSERT_TRUE(detail::equal(result.view(), expected.view()))
        << "image " << i << ", min_length " << pruning.min_length << ", min_widths "
        << pruning.min_widths;
  }
}

TEST(EdgeWidths, are_twice_the_distances_along_the_line) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Case {
    std::vector<double> distances;
    EdgeWidths widths;  // mean, median, min, max
  };
  for (const auto& [distances, expected] :
       std::vector<Case>{{{1, 3, 2.5}, {13.0 / 3, 5, 2, 6}},
                         {{8, 1, 2, 3}, {7, 5, 2, 16}},  // the mean of both middle ones
                         {{2, 4, 3, 1, 2}, {4.8, 4, 2, 8}},
                         {{infinity, infinity}, {infinity, infinity, infinity, infinity}}}) {
    const Graph graph = graph_of({std::string(distances.size(), '#')});
    const auto width = static_cast<Index>(distances.size());
    const auto found = edge_widths(graph, {distances.data(), width, 1});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_DOUBLE_EQ(found[0].mean, expected.mean);
    EXPECT_DOUBLE_EQ(found[0].median, expected.median);
    EXPECT_DOUBLE_EQ(found[0].min, expected.min);
    EXPECT_DOUBLE_EQ(found[0].max, expected.max);
  }
}

}  // namespace
}  // namespace thinbench
