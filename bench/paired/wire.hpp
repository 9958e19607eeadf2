// What the parent tells a process to measure and what the process answers, as lines of JSON.
#pragma once

#include <string>
#include <vector>

#include "paired/plan.hpp"
#include "paired/rounds.hpp"

namespace thinbench {

/// All that a process has to know.
struct Order {
  std::vector<std::string> pictures;  // instead of the scene
  BinariseOptions binarise;           // of the pictures
  std::vector<Group> groups;
};

/// What one process found in one group.
struct GroupTimes {
  std::size_t group = 0;
  std::vector<EntryTimes> entries;
  std::vector<std::size_t> layout;  // source and destination, modulo 4096
};

[[nodiscard]] std::string to_line(const Order& order);
[[nodiscard]] std::string to_line(const GroupTimes& times);

/// Throw std::runtime_error where the line is something else.
[[nodiscard]] Order order_from(const std::string& line);
[[nodiscard]] GroupTimes group_times_from(const std::string& line);

}  // namespace thinbench
