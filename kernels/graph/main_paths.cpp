#include <algorithm>
#include <limits>

#include "graph/network.hpp"

namespace thinbench {
namespace {

using detail::Network;
using detail::ShortestPaths;
using Nodes = std::vector<std::uint32_t>;

/// Rounding does not decide which of two paths is longer.
constexpr double kRounding = 1e-12;

/// The longest shortest path of a component. Each search narrows how far away the farthest node of
/// every node may be: from node u, whose farthest is e away, v's is at least max(d, e - d) and at
/// most e + d for the distance d between them.
class Diameter {
 public:
  explicit Diameter(const Network& network)
      : paths_(network),
        least_(network.nodes()),
        most_(network.nodes(), std::numeric_limits<double>::infinity()) {}

  /// Of the component of this node, which is its first.
  GraphPath path_of(std::uint32_t first, bool is_tree) {
    longest_ = 0;
    search(first);
    Nodes nodes = paths_.reached();
    std::sort(nodes.begin(), nodes.end());
    search(paths_.reached().back());
    search(paths_.reached().back());
    if (is_tree) {
      // The farthest node is one of the two ends that were searched.
      for (const std::uint32_t node : nodes) most_[node] = least_[node];
    } else {
      rule_out(nodes);
    }
    return first_longest(nodes);
  }

 private:
  [[nodiscard]] bool is_longest(double distance) const {
    return distance >= longest_ * (1 - kRounding);
  }

  void search(std::uint32_t from) {
    paths_.search(from);
    const double farthest = paths_.distance(paths_.reached().back());
    longest_ = std::max(longest_, farthest);
    for (const std::uint32_t node : paths_.reached()) {
      const double distance = paths_.distance(node);
      least_[node] = std::max({least_[node], distance, farthest - distance});
      most_[node] = std::min(most_[node], farthest + distance);
    }
    least_[from] = most_[from] = farthest;
  }

  /// Until no node may be farther from another than the longest path found: alternately from the
  /// node that may have the farthest and from the one that is most central.
  void rule_out(const Nodes& nodes) {
    const auto may_be_longer = [&](std::uint32_t node) {
      return most_[node] > longest_ * (1 + kRounding);
    };
    const auto by = [](const std::vector<double>& bounds) {
      return [&bounds](auto a, auto b) { return bounds[a] < bounds[b]; };
    };
    Nodes open = nodes;
    for (bool central = true;; central = !central) {
      std::erase_if(open, [&](std::uint32_t node) { return !may_be_longer(node); });
      if (open.empty()) return;
      search(central ? *std::min_element(open.begin(), open.end(), by(least_))
                     : *std::max_element(open.begin(), open.end(), by(most_)));
    }
  }

  GraphPath first_longest(const Nodes& nodes) {
    for (const std::uint32_t node : nodes) {
      if (!is_longest(most_[node])) continue;
      if (!is_longest(least_[node])) search(node);
      if (!is_longest(least_[node])) continue;
      paths_.search(node);
      const auto last = std::find_if(nodes.begin(), nodes.end(), [&](std::uint32_t other) {
        return is_longest(paths_.distance(other));
      });
      return paths_.path_to(*last);
    }
    return {0, {nodes.front()}, {}};
  }

  ShortestPaths paths_;
  std::vector<double> least_;  // of the distances of the farthest nodes
  std::vector<double> most_;
  double longest_ = 0;
};

}  // namespace

std::vector<GraphPath> main_paths(std::uint32_t nodes, std::span<const Link> links) {
  const Network network(nodes, links);
  const Nodes components = components_of(nodes, links);
  const std::uint32_t count =
      components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
  std::vector<std::size_t> cycles(count, 1);  // links - nodes + 1
  for (const Link& link : links) ++cycles[components[link.from]];
  for (const std::uint32_t component : components) --cycles[component];
  Diameter diameter(network);
  std::vector<GraphPath> found;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    if (components[node] != found.size()) continue;
    found.push_back(diameter.path_of(node, cycles[components[node]] == 0));
  }
  return found;
}

}  // namespace thinbench
