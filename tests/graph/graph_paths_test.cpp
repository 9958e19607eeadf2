#include "thinbench/graph_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "graph.hpp"
#include "graph/main_paths.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

using Links = std::vector<Link>;
using Numbers = std::vector<std::uint32_t>;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Between all pairs of nodes: Floyd and Warshall.
class AllDistances {
 public:
  AllDistances(std::uint32_t nodes, const Links& links)
      : nodes_(nodes), distances_(std::size_t{nodes} * nodes, kFar) {
    for (std::uint32_t node = 0; node < nodes; ++node) at(node, node) = 0;
    for (const auto& [from, to, length] : links) {
      at(from, to) = at(to, from) = std::min(at(from, to), length);
    }
    for (std::uint32_t by = 0; by < nodes; ++by) {
      for (std::uint32_t a = 0; a < nodes; ++a) {
        for (std::uint32_t b = 0; b < nodes; ++b) {
          at(a, b) = std::min(at(a, b), at(a, by) + at(by, b));
        }
      }
    }
  }

  double& at(std::uint32_t a, std::uint32_t b) { return distances_[std::size_t{a} * nodes_ + b]; }

 private:
  std::uint32_t nodes_;
  std::vector<double> distances_;
};

/// Of whole lengths, so that sums are exact and many paths are equally long.
Links random_links(std::uint32_t nodes, std::mt19937& random) {
  Links links(random() % (2 * nodes));
  const auto longest = 1 + random() % 9;
  for (Link& link : links) {
    link = {static_cast<std::uint32_t>(random() % nodes),
            static_cast<std::uint32_t>(random() % nodes), static_cast<double>(random() % longest)};
  }
  return links;
}

/// Each node but the first is linked to one before it.
Links random_tree(std::uint32_t nodes, std::mt19937& random) {
  Links links;
  for (std::uint32_t node = 1; node < nodes; ++node) {
    links.push_back(
        {static_cast<std::uint32_t>(random() % node), node, static_cast<double>(random() % 5)});
  }
  std::ranges::shuffle(links, random);
  return links;
}

/// Whether the edges lead along the nodes, and have the length.
void must_lead_along(const GraphPath& path, const Links& links, bool is_closed) {
  ASSERT_EQ(path.edges.size() + (is_closed ? 0 : 1), path.nodes.size());
  double length = 0;
  for (std::size_t i = 0; i < path.edges.size(); ++i) {
    const Link& link = links[path.edges[i]];
    const auto ends = std::minmax(path.nodes[i], path.nodes[(i + 1) % path.nodes.size()]);
    ASSERT_EQ(ends, std::minmax(link.from, link.to));
    length += link.length;
  }
  ASSERT_EQ(path.length, length);
}

/// Links with points at whole positions.
struct PointedLinks {
  std::uint32_t nodes;
  Links links;
  std::vector<std::vector<double>> points;

  PointedLinks(std::uint32_t count, Links list, std::mt19937& random)
      : nodes(count), links(std::move(list)), points(links.size()) {
    const auto rarity = 1 + random() % 3;
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (int position = 1; position < links[i].length; ++position) {
        if (random() % rarity == 0) points[i].push_back(position);
      }
    }
  }

  /// Every point a node, after the others, in the order of the links.
  [[nodiscard]] std::pair<std::uint32_t, Links> split() const {
    std::uint32_t count = nodes;
    Links pieces;
    for (std::size_t i = 0; i < links.size(); ++i) {
      std::uint32_t node = links[i].from;
      double done = 0;
      for (const double position : points[i]) {
        pieces.push_back({node, count, position - done});
        node = count++;
        done = position;
      }
      pieces.push_back({node, links[i].to, links[i].length - done});
    }
    return {count, pieces};
  }

  /// The number of a point among the nodes of split().
  [[nodiscard]] std::uint32_t number_of(std::uint32_t link, std::uint32_t point) const {
    std::uint32_t number = nodes + point;
    for (std::uint32_t i = 0; i < link; ++i) number += static_cast<std::uint32_t>(points[i].size());
    return number;
  }

  /// From a node to a point.
  [[nodiscard]] double part(std::uint32_t node, std::uint32_t link, std::uint32_t point) const {
    const auto& [from, to, length] = links[link];
    const double position = points[link].at(point);
    if (from == to) return std::min(position, length - position);
    return node == from ? position : length - position;
  }
};

/// Whether nodes, edges and points are those of a path of this length.
void must_lead_along(GraphPath path, const PointedLinks& graph) {
  if (path.nodes.empty()) {
    const auto& points = graph.points[path.edges.at(0)];
    ASSERT_EQ(path.edges.size(), 1U);
    ASSERT_EQ(path.length, points.at(*path.last_point) - points.at(*path.first_point));
    return;
  }
  if (path.first_point) {
    path.length -= graph.part(path.nodes.front(), path.edges.front(), *path.first_point);
    path.edges.erase(path.edges.begin());
  }
  if (path.last_point) {
    path.length -= graph.part(path.nodes.back(), path.edges.back(), *path.last_point);
    path.edges.pop_back();
  }
  must_lead_along(path, graph.links, false);
}

/// The first pair of nodes, in order, of the component of a node that is farthest apart.
GraphPath farthest_apart(std::uint32_t node, std::uint32_t nodes, AllDistances& distances) {
  GraphPath farthest = {-1, {}, {}};
  for (std::uint32_t a = 0; a < nodes; ++a) {
    for (std::uint32_t b = 0; b < nodes; ++b) {
      const double distance = distances.at(a, b);
      if (distances.at(node, a) == kFar || distance == kFar || distance <= farthest.length)
        continue;
      farthest = {distance, {a, b}, {}};
    }
  }
  return farthest;
}

void must_be_main_paths(const PointedLinks& graph) {
  const auto [count, pieces] = graph.split();
  AllDistances distances(count, pieces);
  const std::vector<GraphPath> paths = detail::main_paths(
      graph.nodes, graph.links, [&](std::uint32_t link) { return graph.points[link]; });
  const Numbers components = components_of(graph.nodes, graph.links);
  std::uint32_t component = 0;
  for (std::uint32_t node = 0; node < graph.nodes; ++node) {
    if (components[node] != component) continue;
    const GraphPath& path = paths.at(component++);
    ASSERT_NO_FATAL_FAILURE(must_lead_along(path, graph));
    const GraphPath expected = farthest_apart(node, count, distances);
    ASSERT_EQ(path.length, expected.length);
    ASSERT_EQ(path.first_point ? graph.number_of(path.edges.front(), *path.first_point)
                               : path.nodes.front(),
              expected.nodes.front());
    ASSERT_EQ(
        path.last_point ? graph.number_of(path.edges.back(), *path.last_point) : path.nodes.back(),
        expected.nodes.back());
  }
  ASSERT_EQ(paths.size(), component);
}

TEST(MainPaths, are_the_first_of_the_longest_shortest_paths_of_random_graphs_and_trees) {
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto nodes = static_cast<std::uint32_t>(1 + random() % 24);
    const PointedLinks graph(nodes, random_links(nodes, random), random);
    ASSERT_NO_FATAL_FAILURE(must_be_main_paths(graph)) << i;
    const PointedLinks tree(nodes, random_tree(nodes, random), random);
    ASSERT_NO_FATAL_FAILURE(must_be_main_paths(tree)) << i;
    Links few = random_links(1 + nodes % 4, random);
    for (Link& link : few) link.length = static_cast<double>(random() % 20);
    ASSERT_NO_FATAL_FAILURE(must_be_main_paths({1 + nodes % 4, few, random})) << i;
  }
}

/// The number of the point where a path begins or ends: nodes, then pixels of edges.
std::size_t number_of(const Graph& graph, std::uint32_t node) {
  EXPECT_LT(node, graph.nodes.size());
  return node;
}
std::size_t number_of(const Graph& graph, std::uint32_t edge, std::uint32_t point) {
  EXPECT_LT(point, graph.edges.at(edge).pixel_count);
  return graph.nodes.size() + graph.edges[edge].first_pixel + point;
}

/// The length of the steps between these pixels; within a node they have none.
double length_along(const Graph& graph, const std::vector<Pixel>& pixels, const Spacing& spacing) {
  std::map<std::pair<int, int>, std::size_t> nodes;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    for (const Pixel p : graph.pixels_of(graph.nodes[i])) nodes[{p.x, p.y}] = i;
  }
  double length = 0;
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    const Pixel a = pixels[i - 1], b = pixels[i];
    const auto one = nodes.find({a.x, a.y}), other = nodes.find({b.x, b.y});
    if (one != nodes.end() && other != nodes.end() && one->second == other->second) continue;
    EXPECT_EQ(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1);
    length += std::hypot((a.x - b.x) * spacing.x, (a.y - b.y) * spacing.y);
  }
  return length;
}

void must_be_those_of_all_pixels(const ConstImageView& image, const Spacing& spacing = {}) {
  const Graph graph = skeleton_graph(image);
  const std::vector<GraphPath> paths = main_paths(graph, spacing);
  const std::vector<reference::MainPath> expected = reference::main_paths(image, spacing);
  ASSERT_EQ(paths.size(), expected.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const GraphPath& path = paths[i];
    const double rounding = 1e-12 * expected[i].length;
    ASSERT_NEAR(path.length, expected[i].length, rounding);
    ASSERT_NEAR(length_along(graph, points_of(graph, path, spacing), spacing), path.length,
                rounding);
    ASSERT_EQ(path.first_point ? number_of(graph, path.edges.front(), *path.first_point)
                               : number_of(graph, path.nodes.front()),
              expected[i].first);
    ASSERT_EQ(path.last_point ? number_of(graph, path.edges.back(), *path.last_point)
                              : number_of(graph, path.nodes.back()),
              expected[i].last);
  }
}

TEST(MainPaths, lead_between_the_farthest_of_all_pixels_of_every_image_of_4_by_4) {
  for (unsigned code = 0; code < 1U << 16; ++code) {
    const ByteImage image =
        image_by(4, 4, [=](Index x, Index y) { return code >> (4 * y + x) & 1; });
    ASSERT_NO_FATAL_FAILURE(must_be_those_of_all_pixels(image.view())) << code;
  }
}

TEST(MainPaths, lead_between_the_farthest_of_all_pixels_of_random_skeletons) {
  std::mt19937 random(5);
  for (int i = 0; i < 600; ++i) {
    const auto width = static_cast<Index>(1 + random() % 14), height = width + i % 3;
    const auto rarity = static_cast<unsigned>(3 + random() % 12);
    ByteImage image =
        image_by(width, height, [&](Index, Index) { return random() % rarity == 0 ? 0 : 255; });
    thin(Rule::guo_hall, image.view(), image.view());
    ASSERT_NO_FATAL_FAILURE(must_be_those_of_all_pixels(image.view())) << i;
    ASSERT_NO_FATAL_FAILURE(must_be_those_of_all_pixels(image.view(), {.x = 2, .y = 0.3})) << i;
  }
}

TEST(MainPaths, of_a_ring_is_half_of_it) {
  const Graph ring = skeleton_graph(image_of({".###.",  //
                                              "#...#",  //
                                              "#...#",  //
                                              "#...#",  //
                                              ".###."})
                                        .view());
  const GraphPath path = main_paths(ring).at(0);
  EXPECT_DOUBLE_EQ(path.length, 4 + 2 * std::sqrt(2.0));
  EXPECT_EQ(path.nodes, (Numbers{0}));
  EXPECT_EQ(path.edges, (Numbers{0}));
  EXPECT_FALSE(path.first_point.has_value());
  EXPECT_EQ(ring.pixels_of(ring.edges[0])[path.last_point.value()], (Pixel{3, 4}));
  EXPECT_EQ(points_of(ring, path),
            (std::vector<Pixel>{{1, 0}, {2, 0}, {3, 0}, {4, 1}, {4, 2}, {4, 3}, {3, 4}}));
}

TEST(Cycles, are_as_many_as_links_beyond_a_forest_and_each_has_its_own_longest_link) {
  std::mt19937 random(3);
  for (int i = 0; i < 3000; ++i) {
    const auto nodes = static_cast<std::uint32_t>(1 + random() % 24);
    const Links links = random_links(nodes, random);
    const std::vector<GraphPath> found = cycles(nodes, links);
    const Numbers components = components_of(nodes, links);
    ASSERT_EQ(found.size(), links.size() - nodes + std::ranges::max(components) + 1);
    std::set<std::uint32_t> closing;
    for (const GraphPath& cycle : found) {
      ASSERT_NO_FATAL_FAILURE(must_lead_along(cycle, links, true));
      ASSERT_EQ(std::set(cycle.nodes.begin(), cycle.nodes.end()).size(), cycle.nodes.size());
      ASSERT_TRUE(closing.insert(cycle.edges.back()).second);
      for (const std::uint32_t edge : cycle.edges) {
        ASSERT_LE(links[edge].length, links[cycle.edges.back()].length);
      }
    }
    for (const GraphPath& cycle : found) {
      const auto shared = std::ranges::count_if(
          cycle.edges, [&](std::uint32_t edge) { return closing.contains(edge); });
      ASSERT_EQ(shared, 1);
    }
  }
}

TEST(Components, are_numbered_by_their_first_nodes) {
  EXPECT_EQ(components_of(5, Links{{4, 1, 1}, {2, 2, 1}, {3, 0, 0}}), (Numbers{0, 1, 2, 0, 1}));
}

TEST(ShortestPath, is_as_short_as_any_of_random_graphs) {
  std::mt19937 random(4);
  for (int i = 0; i < 500; ++i) {
    const auto nodes = static_cast<std::uint32_t>(1 + random() % 20);
    const Links links = random_links(nodes, random);
    AllDistances distances(nodes, links);
    for (std::uint32_t to = 0; to < nodes; ++to) {
      const auto path = shortest_path(nodes, links, 0, to);
      ASSERT_EQ(path.has_value(), distances.at(0, to) != kFar);
      if (!path) continue;
      ASSERT_NO_FATAL_FAILURE(must_lead_along(*path, links, false));
      ASSERT_EQ(path->length, distances.at(0, to));
      ASSERT_EQ(path->nodes.back(), to);
    }
  }
}

TEST(ShortestPath, is_found_where_its_length_overflows) {
  const GraphPath path = shortest_path(3, Links{{0, 1, 1e308}, {1, 2, 1e308}}, 0, 2).value();
  EXPECT_EQ(path.nodes, (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace thinbench
