// Epochs of several entries, interleaved, so that none has the quiet moments alone.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "measure/plan.hpp"

namespace thinbench {

/// Makes the calls of an epoch and returns their nanoseconds.
using Visit = std::function<double(std::size_t entry)>;

/// Nanoseconds of a call, for each epoch. Rounded to five digits.
using EntryTimes = std::vector<double>;

/// 0 .. n - 1 in an order that depends on the seed alone.
[[nodiscard]] std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed);

/// Visits every entry as often as it says, in rounds of random order; entries of fewer visits are
/// done earlier.
[[nodiscard]] std::vector<EntryTimes> measure_rounds(const std::vector<Entry>& entries,
                                                     std::uint64_t seed, const Visit& visit);

}  // namespace thinbench
