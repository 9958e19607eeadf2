// Nodes and the links between them, for searches.
#pragma once

#include <cstdint>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "thinbench/graph_paths.hpp"

namespace thinbench::detail {

inline constexpr std::uint32_t kNoLink = 0xFFFFFFFF;

/// The links of every node, one list after another.
class Network {
 public:
  /// Throws std::invalid_argument for links that do not fit.
  Network(std::uint32_t nodes, std::span<const Link> links);

  [[nodiscard]] std::uint32_t nodes() const { return nodes_; }
  [[nodiscard]] std::span<const std::uint32_t> links_of(std::uint32_t node) const {
    return std::span(numbers_).subspan(first_[node], first_[node + 1] - first_[node]);
  }
  [[nodiscard]] const Link& link(std::uint32_t number) const { return links_[number]; }
  [[nodiscard]] std::uint32_t other_end(std::uint32_t number, std::uint32_t node) const {
    return links_[number].from ^ links_[number].to ^ node;
  }

 private:
  std::uint32_t nodes_;
  std::span<const Link> links_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> numbers_;
};

/// Shortest paths from one node to all others: Dijkstra's algorithm.
class ShortestPaths {
 public:
  explicit ShortestPaths(const Network& network);

  /// Only nodes that can be reached have results afterwards.
  void search(std::uint32_t from);

  /// In the order of their distances.
  [[nodiscard]] const std::vector<std::uint32_t>& reached() const { return reached_; }
  [[nodiscard]] bool is_reached(std::uint32_t node) const;
  [[nodiscard]] double distance(std::uint32_t node) const { return distances_[node]; }
  [[nodiscard]] GraphPath path_to(std::uint32_t node) const;

 private:
  using Entry = std::pair<double, std::uint32_t>;

  void offer(std::uint32_t node, double distance, std::uint32_t link);

  const Network& network_;
  std::vector<double> distances_;
  std::vector<std::uint32_t> links_;  // by which nodes are reached
  std::vector<std::uint32_t> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace thinbench::detail
