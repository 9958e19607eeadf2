#include <algorithm>
#include <numeric>
#include <utility>

#include "core/union_find.hpp"
#include "graph/network.hpp"

namespace thinbench {
namespace {

using detail::kNoLink;
using detail::Network;
using Numbers = std::vector<std::uint32_t>;

/// Each node its own parent.
Numbers nodes_alone(std::uint32_t nodes) {
  Numbers parents(nodes);
  std::iota(parents.begin(), parents.end(), 0U);
  return parents;
}

/// The shortest spanning forest; `closing` gets the links that are not in it.
std::vector<Link> spanning_forest(std::uint32_t nodes, std::span<const Link> links,
                                  Numbers& in_forest, Numbers& closing) {
  Numbers order(links.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return links[a].length < links[b].length; });
  Numbers parents = nodes_alone(nodes);
  for (const std::uint32_t i : order) {
    const bool are_joined = detail::find_root(parents.data(), links[i].from) ==
                            detail::find_root(parents.data(), links[i].to);
    (are_joined ? closing : in_forest).push_back(i);
    detail::unite(parents.data(), links[i].from, links[i].to);
  }
  std::sort(closing.begin(), closing.end());
  std::vector<Link> forest;
  for (const std::uint32_t i : in_forest) forest.push_back(links[i]);
  return forest;
}

/// A forest as the way from every node to the first of its tree.
class Roots {
 public:
  explicit Roots(const Network& forest)
      : forest_(forest), links_(forest.nodes(), kNoLink), depths_(forest.nodes(), kNoLink) {
    Numbers to_visit;
    for (std::uint32_t root = 0; root < forest.nodes(); ++root) {
      if (depths_[root] != kNoLink) continue;
      depths_[root] = 0;
      for (to_visit.assign(1, root); !to_visit.empty();) {
        const std::uint32_t node = to_visit.back();
        to_visit.pop_back();
        for (const std::uint32_t link : forest.links_of(node)) visit(link, node, to_visit);
      }
    }
  }

  /// Between two nodes of a tree; edges by their numbers in the forest.
  [[nodiscard]] GraphPath between(std::uint32_t from, std::uint32_t to) const {
    GraphPath up = {0, {from}, {}};
    GraphPath down = {0, {to}, {}};
    while (from != to) {
      const bool climbs = depths_[from] >= depths_[to];
      std::uint32_t& node = climbs ? from : to;
      GraphPath& way = climbs ? up : down;
      way.edges.push_back(links_[node]);
      node = forest_.other_end(links_[node], node);
      way.nodes.push_back(node);
    }
    up.nodes.insert(up.nodes.end(), down.nodes.rbegin() + 1, down.nodes.rend());
    up.edges.insert(up.edges.end(), down.edges.rbegin(), down.edges.rend());
    return up;
  }

 private:
  void visit(std::uint32_t link, std::uint32_t node, Numbers& to_visit) {
    const std::uint32_t next = forest_.other_end(link, node);
    if (depths_[next] != kNoLink) return;
    depths_[next] = depths_[node] + 1;
    links_[next] = link;
    to_visit.push_back(next);
  }

  const Network& forest_;
  Numbers links_;  // towards the root
  Numbers depths_;
};

}  // namespace

std::vector<std::uint32_t> components_of(std::uint32_t nodes, std::span<const Link> links) {
  const Network network(nodes, links);  // checks the links
  Numbers parents = nodes_alone(nodes);
  for (const Link& link : links) detail::unite(parents.data(), link.from, link.to);
  Numbers components(nodes);
  std::uint32_t count = 0;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    const std::uint32_t first = detail::find_root(parents.data(), node);
    components[node] = first == node ? count++ : components[first];
  }
  return components;
}

std::vector<GraphPath> cycles(std::uint32_t nodes, std::span<const Link> links) {
  const Network network(nodes, links);  // checks the links
  Numbers in_forest;
  Numbers closing;
  const std::vector<Link> trees = spanning_forest(nodes, links, in_forest, closing);
  const Network forest(nodes, trees);
  const Roots roots(forest);
  std::vector<GraphPath> found;
  for (const std::uint32_t last : closing) {
    GraphPath cycle = roots.between(links[last].to, links[last].from);
    for (std::uint32_t& edge : cycle.edges) edge = in_forest[edge];
    cycle.edges.push_back(last);
    for (const std::uint32_t edge : cycle.edges) cycle.length += links[edge].length;
    found.push_back(std::move(cycle));
  }
  return found;
}

}  // namespace thinbench
