#include "thinbench/graph_paths.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "support/rejection.hpp"
#include "support/text_image.hpp"

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

void must_be_main_paths(std::uint32_t nodes, const Links& links) {
  AllDistances distances(nodes, links);
  const std::vector<GraphPath> paths = main_paths(nodes, links);
  const Numbers components = components_of(nodes, links);
  std::uint32_t count = 0;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    if (components[node] != count) continue;
    const GraphPath& path = paths.at(count++);
    must_lead_along(path, links, false);
    const GraphPath expected = farthest_apart(node, nodes, distances);
    ASSERT_EQ(path.length, expected.length);
    ASSERT_EQ(path.nodes.front(), expected.nodes.front());
    ASSERT_EQ(path.nodes.back(), expected.nodes.back());
  }
  ASSERT_EQ(paths.size(), count);
}

TEST(MainPaths, are_the_first_of_the_longest_shortest_paths_of_random_graphs_and_trees) {
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto nodes = static_cast<std::uint32_t>(1 + random() % 24);
    ASSERT_NO_FATAL_FAILURE(must_be_main_paths(nodes, random_links(nodes, random))) << i;
    ASSERT_NO_FATAL_FAILURE(must_be_main_paths(nodes, random_tree(nodes, random))) << i;
  }
}

TEST(MainPaths, of_a_comb_leads_from_the_first_tooth_to_the_last) {
  const Graph graph = skeleton_graph(image_of({"#...#...#",  //
                                               "#...#...#",  //
                                               "#########"})
                                         .view());
  const std::vector<GraphPath> paths = main_paths(4, links_of(graph));
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_DOUBLE_EQ(paths[0].length, 12);
  EXPECT_EQ(paths[0].nodes, (Numbers{0, 3, 2}));
  EXPECT_DOUBLE_EQ(main_paths(4, links_of(graph, {.x = 3, .y = 0.5}))[0].length, 26);
}

TEST(MainPaths, of_nodes_without_links_are_these) {
  EXPECT_TRUE(main_paths(0, {}).empty());
  const std::vector<GraphPath> paths = main_paths(2, {});
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[1], (GraphPath{0, {1}, {}}));
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

TEST(Cycles, of_an_eight_are_its_two_rings) {
  const Graph graph = skeleton_graph(image_of({".#####.",  //
                                               "#..#..#",  //
                                               "#..#..#",  //
                                               ".#####."})
                                         .view());
  const Links links = links_of(graph);
  const std::vector<GraphPath> found = cycles(2, links);
  ASSERT_EQ(found.size(), 2U);
  for (const GraphPath& cycle : found) EXPECT_EQ(cycle.edges.size(), 2U);
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

TEST(GraphPaths, reject_links_and_nodes_that_are_not_there) {
  const auto rejected = [](const Links& links) {
    return rejection_of([&] { static_cast<void>(main_paths(2, links)); });
  };
  EXPECT_EQ(rejected({{0, 1, 1}, {0, 2, 1}}), "link 1: expected nodes below 2, got 0 and 2");
  EXPECT_EQ(rejected({{0, 1, -1}}),
            "link 0: length: expected a finite number of at least 0, got -1");
  EXPECT_EQ(rejected({{0, 1, std::numeric_limits<double>::infinity()}}),
            "link 0: length: expected a finite number of at least 0, got inf");
  EXPECT_EQ(rejection_of([] { static_cast<void>(shortest_path(2, {}, 0, 2)); }),
            "expected nodes below 2, got 0 and 2");
}

}  // namespace
}  // namespace thinbench
