#include "thinbench/graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "graph.hpp"
#include "support/rejection.hpp"
#include "support/text_image.hpp"
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
  ByteImage image(1 + static_cast<Index>(random() % 80), 1 + static_cast<Index>(random() % 12));
  const auto rarity = static_cast<unsigned>(2 + random() % 6);
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      if (random() % rarity == 0) image.at(x, y) = 255;
    }
  }
  return image;
}

ByteImage transposed(const ByteImage& image) {
  ByteImage result(image.height(), image.width());
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) result.at(y, x) = image.at(x, y);
  }
  return result;
}

TEST(SkeletonGraph, of_a_line_has_two_ends_and_an_edge) {
  const Graph graph = graph_of({"#....",  //
                                ".###.",  //
                                "....#"});
  EXPECT_EQ(kinds_of(graph), (Kinds{end, end}));
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.edges[0], (GraphEdge{0, 1, {0, 0}, {4, 2}, 0, 3, {2, 0, 2}}));
  EXPECT_DOUBLE_EQ(length_of(graph.edges[0]), 2 + 2 * std::sqrt(2.0));
}

TEST(SkeletonGraph, lengths_are_in_the_unit_of_the_spacing) {
  const Graph graph = graph_of({"##...",  //
                                "..#..",  //
                                "..#..",  //
                                "..###"});
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.edges[0].steps, (Steps{3, 2, 1}));
  EXPECT_DOUBLE_EQ(length_of(graph.edges[0], {.y = 4, .x = 3}), 3 * 3 + 2 * 4 + 5);
}

TEST(SkeletonGraph, a_corner_is_no_junction) {
  EXPECT_EQ(kinds_of(graph_of({"##.",  //
                               ".##",  //
                               "..#"})),
            (Kinds{end, end}));
}

TEST(SkeletonGraph, joined_junction_pixels_are_one_node) {
  const Graph graph = graph_of({"#...#",  //
                                ".#.#.",  //
                                "..#..",  //
                                "..#..",  //
                                ".#.#.",  //
                                "#...#"});
  EXPECT_EQ(kinds_of(graph), (Kinds{end, end, junction, end, end}));
  EXPECT_EQ(graph.pixels_of(graph.nodes[2]).size(), 2U);
  EXPECT_EQ(graph.edges.size(), 4U);
}

TEST(SkeletonGraph, single_pixels_and_closed_lines_are_nodes) {
  const Graph graph = graph_of({".#....",  //
                                "#.#..#",  //
                                ".#...."});
  EXPECT_EQ(kinds_of(graph), (Kinds{isolated, cycle}));
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.edges[0], (GraphEdge{1, 1, {1, 0}, {1, 0}, 0, 3, {0, 0, 4}}));
}

TEST(SkeletonGraph, parallel_edges_and_loops_are_kept) {
  const Graph ring_with_tails = graph_of({"...##...",  //
                                          "###..###",  //
                                          "...##..."});
  EXPECT_EQ(kinds_of(ring_with_tails), (Kinds{end, junction, junction, end}));
  EXPECT_EQ(ring_with_tails.edges.size(), 4U);
  const Graph loop = graph_of({"....##.",  //
                               "####..#",  //
                               "....##."});
  EXPECT_EQ(kinds_of(loop), (Kinds{end, junction}));
  ASSERT_EQ(loop.edges.size(), 2U);
  EXPECT_EQ(loop.edges[1].from, loop.edges[1].to);
}

TEST(SkeletonGraph, a_hole_within_a_junction_is_a_loop_without_pixels) {
  const Graph graph = graph_of({"..#..",  //
                                "..#..",  //
                                "##.##",  //
                                "..#..",  //
                                "..#.."});
  EXPECT_EQ(kinds_of(graph), (Kinds{end, junction, end, end, end}));
  EXPECT_EQ(graph.edges.size(), 5U);
  EXPECT_EQ(graph.edges.back().pixel_count, 0U);
}

TEST(SkeletonGraph, a_full_block_is_a_junction) {
  const Graph graph = graph_of({"##..",  //
                                "####"});
  EXPECT_EQ(kinds_of(graph), (Kinds{junction, end}));
  EXPECT_EQ(graph.nodes[0].pixel_count, 4U);
}

TEST(ClassifyPixels, follows_the_definition_of_degrees) {
  const ByteImage image = image_of({"#.###..",  //
                                    "....#.#",  //
                                    "##..###",  //
                                    "##....#"});
  ByteImage classes(7, 4), degrees(7, 4);
  classify_pixels(image.view(), classes.view(), degrees.view());
  const auto lines = [](const ByteImage& values) {
    TextImage text;
    for (Index y = 0; y < values.height(); ++y) {
      text.emplace_back();
      for (Index x = 0; x < values.width(); ++x)
        text.back() += static_cast<char>('0' + values.at(x, y));
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

TEST(ClassifyPixels, agrees_with_the_nodes_of_the_graph) {
  std::mt19937 random(4);
  for (int i = 0; i < 2000; ++i) {
    const ByteImage image = random_image(random);
    ByteImage classes(image.width(), image.height());
    classify_pixels(image.view(), classes.view(), {});
    const Graph graph = skeleton_graph(image.view());
    ByteImage expected(image.width(), image.height());
    for (const Pixel p : graph.edge_pixels) expected.at(p.x, p.y) = 3;
    for (const GraphNode& node : graph.nodes) {
      constexpr std::array<std::uint8_t, 4> class_of_kind = {1, 2, 4, 3};
      for (const Pixel p : graph.pixels_of(node)) {
        expected.at(p.x, p.y) = class_of_kind[static_cast<std::size_t>(node.kind)];
      }
    }
    ASSERT_TRUE(equal(classes.view(), expected.view()));
  }
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

TEST(ClassifyPixels, rejects_unsuitable_views) {
  ByteImage image(8, 4), small(7, 4);
  EXPECT_NE(rejection_of([&] { classify_pixels(image.view(), small.view(), {}); }), "");
  EXPECT_NE(rejection_of([&] { classify_pixels(image.view(), {}, image.view()); }), "");
  ByteImage both(8, 4);
  EXPECT_NE(rejection_of([&] { classify_pixels(image.view(), both.view(), both.view()); }), "");
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

TEST(SkeletonGraph, rejects_unsuitable_images) {
  const std::vector<std::uint8_t> pixels(6);
  const Index too_wide = (Index{1} << 29) + 1;
  const std::vector<ConstImageView> unsuitable = {{pixels.data(), -1, 2},
                                                  {pixels.data(), 3, 2, 2},
                                                  {nullptr, 3, 2},
                                                  {pixels.data(), too_wide, 1}};
  for (const ConstImageView& image : unsuitable) {
    EXPECT_NE(rejection_of([&] { static_cast<void>(skeleton_graph(image)); }), "");
    EXPECT_NE(rejection_of([&] { static_cast<void>(full_blocks(image)); }), "");
    EXPECT_NE(rejection_of([&] { classify_pixels(image, {}, {}); }), "");
  }
}

TEST(SkeletonGraph, has_every_pixel_once_and_the_euler_number_on_20000_random_images) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const ByteImage image = random_image(random);
    const Graph graph = skeleton_graph(image.view());
    ByteImage drawn(image.width(), image.height());
    for (const std::vector<Pixel>& list : {graph.node_pixels, graph.edge_pixels}) {
      for (const Pixel p : list) {
        ASSERT_EQ(drawn.at(p.x, p.y), 0);
        drawn.at(p.x, p.y) = 255;
      }
    }
    ASSERT_TRUE(equal(drawn.view(), image.view()));
    ASSERT_EQ(static_cast<std::int64_t>(graph.nodes.size()) -
                  static_cast<std::int64_t>(graph.edges.size()),
              euler_number(image.view()));
  }
}

/// What does not depend on the order: kinds and sizes of nodes, ends and lengths of edges.
auto summary_of(const Graph& graph, bool transposed) {
  std::multiset<std::tuple<int, std::int32_t, std::int32_t>> nodes;
  for (const GraphNode& node : graph.nodes) {
    if (node.kind == cycle) continue;  // its pixel depends on the order
    std::int32_t x = 0;
    std::int32_t y = 0;
    for (const Pixel p : graph.pixels_of(node)) {
      x += p.x;
      y += p.y;
    }
    if (transposed) std::swap(x, y);
    nodes.emplace(static_cast<int>(node.kind), x, y);
  }
  std::multiset<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges;
  for (const GraphEdge& edge : graph.edges) {
    edges.emplace(edge.pixel_count, edge.steps.horizontal + edge.steps.vertical,
                  edge.steps.diagonal);
  }
  return std::pair(nodes, edges);
}

TEST(SkeletonGraph, of_a_transposed_image_is_the_same_up_to_order) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const ByteImage image = random_image(random);
    ASSERT_EQ(summary_of(skeleton_graph(image.view()), false),
              summary_of(skeleton_graph(transposed(image).view()), true));
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

TEST(Prune, keeps_a_branch_of_every_component_unless_asked) {
  EXPECT_EQ(text_of(pruned(kSpurs, {.min_length = 100}))[2], "############");
  EXPECT_EQ(text_of(pruned(kSpurs, {.min_length = 3, .removes_components = true}))[4],
            "............");
  EXPECT_EQ(text_of(pruned(kSpurs, {.min_length = 100, .removes_components = true})),
            TextImage(5, std::string(12, '.')));
}

TEST(Prune, keeps_lines_of_the_length) {
  const Pruning pruning = {.min_length = 1, .removes_components = true};
  EXPECT_EQ(text_of(pruned({"##.#"}, pruning)), (TextImage{"##.."}));
}

TEST(Prune, takes_limits_in_widths) {
  std::vector<double> distances(60, 1);  // a width of 2 everywhere
  Pruning pruning = {.min_widths = 0.9};
  pruning.distances = {distances.data(), 12, 5};
  EXPECT_EQ(text_of(pruned(kSpurs, pruning))[1], "....#.......");
  distances[2 * 12 + 4] = 3;
  EXPECT_EQ(text_of(pruned(kSpurs, pruning))[1], "............");
}

TEST(Prune, keeps_components_and_holes) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const ByteImage image = random_image(random);
    ByteImage result(image.width(), image.height());
    const Graph graph = prune(image.view(), result.view(), {.min_length = 1.0 + i % 7});
    ASSERT_EQ(graph, skeleton_graph(result.view()));
    ASSERT_EQ(euler_number(image.view()), euler_number(result.view()));
    ASSERT_EQ(find_components(image.view()).size(), find_components(result.view()).size());
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

TEST(Prune, rejects_unsuitable_arguments) {
  ByteImage image = image_of(kSpurs);
  const auto rejected = [&](const Pruning& pruning) {
    return rejection_of([&] { prune(image.view(), image.view(), pruning); });
  };
  EXPECT_EQ(rejected({.min_length = -1}),
            "min_length: expected a finite number of at least 0, got -1");
  EXPECT_EQ(rejected({.min_length = std::nan("")}),
            "min_length: expected a finite number of at least 0, got nan");
  EXPECT_EQ(rejected({.min_widths = 1}), "min_widths: expected distances of size 12 x 5");
  EXPECT_EQ(rejected({.spacing = {1, 0}}),
            "spacing: expected numbers from 1e-30 to 1e30, got 1, 0");
  EXPECT_EQ(text_of(image), kSpurs);
}

TEST(Prune, rejects_distances_whose_rows_overlap) {
  ByteImage image = image_of(kSpurs);
  const std::vector<double> numbers(60, 1);
  for (const Index stride : {Index{-12}, Index{11}}) {
    Pruning pruning = {.min_widths = 1};
    pruning.distances = {numbers.data(), 12, 5, stride};
    EXPECT_EQ(rejection_of([&] { prune(image.view(), image.view(), pruning); }),
              "distances has a stride of " + std::to_string(stride) + ", below its width of 12");
  }
  EXPECT_EQ(text_of(image), kSpurs);
}

TEST(EdgeWidths, are_twice_the_distances_along_the_line) {
  const Graph graph = graph_of({"###"});
  const std::vector<double> distances = {1, 3, 2.5};
  const std::vector<EdgeWidths> widths = edge_widths(graph, {distances.data(), 3, 1});
  ASSERT_EQ(widths.size(), 1U);
  EXPECT_DOUBLE_EQ(widths[0].mean, 13.0 / 3);
  EXPECT_DOUBLE_EQ(widths[0].median, 5);
  EXPECT_DOUBLE_EQ(widths[0].least, 2);
  EXPECT_DOUBLE_EQ(widths[0].greatest, 6);
  EXPECT_NE(rejection_of([&] {
              static_cast<void>(edge_widths(graph, {distances.data(), 2, 1}));
            }),
            "");
}

TEST(EdgeWidths, have_the_mean_of_both_middle_ones_as_median_of_an_even_number) {
  const Graph graph = graph_of({"####"});
  const std::vector<double> distances = {8, 1, 2, 3};
  EXPECT_DOUBLE_EQ(edge_widths(graph, {distances.data(), 4, 1}).at(0).median, 5);
}

TEST(EdgeWidths, are_least_and_greatest_anywhere_on_the_line) {
  const Graph graph = graph_of({"#####"});
  const std::vector<double> distances = {2, 4, 3, 1, 2};
  const std::vector<EdgeWidths> widths = edge_widths(graph, {distances.data(), 5, 1});
  EXPECT_DOUBLE_EQ(widths.at(0).mean, 4.8);
  EXPECT_DOUBLE_EQ(widths.at(0).least, 2);
  EXPECT_DOUBLE_EQ(widths.at(0).greatest, 8);
}

TEST(EdgeWidths, reject_distances_without_data_or_with_rows_that_overlap) {
  const Graph graph = graph_of({"###", "###"});
  const std::vector<double> numbers(6, 1);
  const auto rejected = [&](const View<const double>& distances) {
    return rejection_of([&] { static_cast<void>(edge_widths(graph, distances)); });
  };
  EXPECT_EQ(rejected({nullptr, 3, 2}), "distances has no data");
  EXPECT_TRUE(edge_widths({}, {nullptr, 3, 0}).empty());
  EXPECT_EQ(rejected({numbers.data(), 3, 2, -3}),
            "distances has a stride of -3, below its width of 3");
}

TEST(Polyline, keeps_what_is_farther_than_the_tolerance) {
  const Graph graph = graph_of({"#.....#",  //
                                ".#...#.",  //
                                "..#.#..",  //
                                "...#..."});
  const std::vector<Pixel> points = points_of(graph, graph.edges.at(0));
  EXPECT_EQ(polyline(points, 1), (std::vector<Pixel>{{0, 0}, {3, 3}, {6, 0}}));
  EXPECT_EQ(polyline(points, 3), (std::vector<Pixel>{{0, 0}, {6, 0}}));
  EXPECT_NE(rejection_of([&] { static_cast<void>(polyline(points, -1)); }), "");
}

TEST(Polyline, measures_from_lines_of_one_step_too) {
  const std::vector<Pixel> points = {{0, 0}, {4, 0}, {1, 0}};
  EXPECT_EQ(polyline(points, 3), (std::vector<Pixel>{{0, 0}, {1, 0}}));
}

TEST(Polyline, of_straight_lines_has_two_points_without_any_tolerance) {
  for (std::int32_t length = 2; length <= 500; ++length) {
    std::vector<Pixel> row, diagonal;
    for (std::int32_t i = 0; i < length; ++i) {
      row.push_back({7, 3 + i});
      diagonal.push_back({1 + i, 9 - i});
    }
    ASSERT_EQ(polyline(row, 0).size(), 2U);
    ASSERT_EQ(polyline(diagonal, 0).size(), 2U);
  }
}

TEST(EdgeWidths, without_background_are_infinite) {
  const Graph graph = graph_of({"###"});
  const std::vector<double> distances(3, std::numeric_limits<double>::infinity());
  const EdgeWidths width = edge_widths(graph, {distances.data(), 3, 1}).at(0);
  EXPECT_TRUE(std::isinf(width.mean) && std::isinf(width.least) && std::isinf(width.greatest));
}

TEST(Polyline, of_no_points_is_empty) {
  EXPECT_EQ(polyline({}, 1), std::vector<Pixel>());
}

TEST(Polyline, takes_points_as_far_apart_as_numbers_allow) {
  constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();
  const std::vector<Pixel> points = {{-far - 1, 0}, {0, 3}, {far, 0}};
  EXPECT_EQ(polyline(points, 3.5), (std::vector<Pixel>{points[0], points[2]}));
  EXPECT_EQ(polyline(points, 2.5), points);
}

TEST(Polyline, of_a_closed_line_keeps_what_is_far_from_its_start) {
  const Graph graph = graph_of({".###.",  //
                                "#...#",  //
                                ".###."});
  EXPECT_GE(polyline(points_of(graph, graph.edges.at(0)), 0.5).size(), 4U);
}

}  // namespace
}  // namespace thinbench
