// Order statistics of few values: nothing is assumed of how they are distributed.
#pragma once

#include <cstddef>
#include <vector>

namespace thinbench {

/// The middle value, or the mean of the two in the middle. Throws std::invalid_argument for none.
[[nodiscard]] double median(std::vector<double> values);

/// The interval between two of n ordered values, which holds the median of what they were drawn
/// from with probability `coverage`.
struct Ranks {
  std::size_t low;  // counted from 1
  std::size_t high;
  double coverage;
};

/// The narrowest symmetric pair of ranks that covers at least 95 %: 2 and 8 of 9. Below six values
/// no pair does, and the ranks are 1 and n.
[[nodiscard]] Ranks interval_ranks(std::size_t n);

/// A ratio measured by several processes, each of which gave the logarithm of one.
struct Estimate {
  std::vector<double> logs;  // a process each, in their order
  double ratio;
  double low;
  double high;
};

[[nodiscard]] Estimate estimate_of(std::vector<double> logs);

}  // namespace thinbench
