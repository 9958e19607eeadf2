#include "graph/network.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/checks.hpp"

namespace thinbench {
namespace detail {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kLongest = std::numeric_limits<double>::max();

void check(std::uint32_t nodes, std::span<const Link> links) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto& [from, to, length] = links[i];
    if (std::max(from, to) < nodes && length >= 0 && length < kFar) continue;
    const std::string name = "link " + std::to_string(i);
    require(std::max(from, to) < nodes, name + ": expected nodes below " + std::to_string(nodes) +
                                            ", got " + std::to_string(from) + " and " +
                                            std::to_string(to));
    require_not_negative((name + ": length").c_str(), length);
  }
}

}  // namespace

Network::Network(std::uint32_t nodes, std::span<const Link> links)
    : nodes_(nodes), links_(links), first_(std::size_t{nodes} + 2) {
  require(links.size() < kNoLink, "links: expected less than 2^32 - 1");
  check(nodes, links);
  for (const Link& link : links) {
    ++first_[link.from + 2];
    if (link.to != link.from) ++first_[link.to + 2];
  }
  for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
  numbers_.resize(first_.back());
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    numbers_[first_[links[i].from + 1]++] = i;
    if (links[i].to != links[i].from) numbers_[first_[links[i].to + 1]++] = i;
  }
}

ShortestPaths::ShortestPaths(const Network& network)
    : network_(network), distances_(network.nodes(), kFar), links_(network.nodes(), kNoLink) {}

bool ShortestPaths::is_reached(std::uint32_t node) const {
  return distances_[node] < kFar;
}

void ShortestPaths::search(std::uint32_t from) {
  for (const std::uint32_t node : reached_) distances_[node] = kFar;
  reached_.clear();
  offer(from, 0, kNoLink);
  while (!open_.empty()) {
    const auto [distance, node] = open_.top();
    open_.pop();
    if (distance > distances_[node]) continue;
    reached_.push_back(node);
    for (const std::uint32_t link : network_.links_of(node)) {
      const double longer = distance + network_.link(link).length;  // may overflow
      offer(network_.other_end(link, node), std::min(longer, kLongest), link);
    }
  }
}

void ShortestPaths::offer(std::uint32_t node, double distance, std::uint32_t link) {
  if (distance >= distances_[node]) return;
  distances_[node] = distance;
  links_[node] = link;
  open_.emplace(distance, node);
}

GraphPath ShortestPaths::path_to(std::uint32_t node) const {
  GraphPath path = {distances_[node], {node}, {}};
  for (std::uint32_t link = links_[node]; link != kNoLink; link = links_[node]) {
    node = network_.other_end(link, node);
    path.edges.push_back(link);
    path.nodes.push_back(node);
  }
  std::reverse(path.edges.begin(), path.edges.end());
  std::reverse(path.nodes.begin(), path.nodes.end());
  return path;
}

}  // namespace detail

std::vector<Link> links_of(const Graph& graph, const Spacing& spacing) {
  detail::require_spacing(spacing);
  std::vector<Link> links;
  links.reserve(graph.edges.size());
  for (const GraphEdge& edge : graph.edges) {
    links.push_back({edge.from, edge.to, length_of(edge, spacing)});
  }
  return links;
}

std::optional<GraphPath> shortest_path(std::uint32_t nodes, std::span<const Link> links,
                                       std::uint32_t from, std::uint32_t to) {
  detail::require(std::max(from, to) < nodes, "expected nodes below " + std::to_string(nodes) +
                                                  ", got " + std::to_string(from) + " and " +
                                                  std::to_string(to));
  const detail::Network network(nodes, links);
  detail::ShortestPaths paths(network);
  paths.search(from);
  if (!paths.is_reached(to)) return std::nullopt;
  return paths.path_to(to);
}

}  // namespace thinbench
