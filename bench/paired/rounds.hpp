// Rounds: all entries of a group visited forwards and backwards, so that every two of them stand as
// A B B A and a drift of the machine cancels.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "paired/plan.hpp"

namespace thinbench {

/// A visit on both clocks, in nanoseconds.
struct Times {
  double thread_cpu = 0;
  double wall = 0;
};

/// Makes the calls of an epoch and returns how long they took together.
using Visit = std::function<Times(std::size_t entry)>;

/// Nanoseconds a counted call of one entry, round by round.
struct EntryTimes {
  std::vector<double> thread_cpu;
  std::vector<double> wall;
};

/// 0 .. n - 1 in an order that depends on the seed alone.
[[nodiscard]] std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed);

/// The entries in the order of one round: short calls in random order, then the long ones, once,
/// in random order, then the short ones backwards. Twice the long calls would double the time of
/// most groups; the epochs before and after a long one already lie symmetrically round it.
[[nodiscard]] std::vector<std::size_t> order_of_round(const std::vector<Entry>& entries,
                                                      std::uint64_t seed);

[[nodiscard]] std::vector<EntryTimes> measure_rounds(const std::vector<Entry>& entries, int rounds,
                                                     std::uint64_t seed, const Visit& visit);

}  // namespace thinbench
