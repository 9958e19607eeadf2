// Rounds: every epoch of a short call stands between two epochs of the anchor, A B A, so that slow
// changes of the machine's speed cancel in the ratio.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "measure/plan.hpp"

namespace thinbench {

/// Nanoseconds on both clocks.
struct Times {
  double thread_cpu = 0;
  double wall = 0;
};

/// Makes the calls of an epoch and returns their total time.
using Visit = std::function<Times(std::size_t entry)>;

/// Thread CPU time for entries on one thread, wall time for others.
struct EntryTimes {
  /// 10^4 ln(time / the anchor's time on the same clock), one value for each epoch; empty for the
  /// anchor.
  std::vector<int> logs;
  /// 10^4 ln(nanoseconds of a call of the anchor beside each of these epochs): how quiet it was.
  std::vector<int> anchor;
  /// 0, 10, 25, 50, 75 and 100 % quantiles of the nanoseconds of a counted call.
  std::array<double, 6> ns = {};
};

/// 0 .. n - 1 in an order that depends on the seed alone.
[[nodiscard]] std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed);

/// A round is half of the sweeps, every long call once, and the other half. A sweep visits the
/// short calls in random order, the anchor before, between and after them. A long call is compared
/// with the median of the anchor's epochs in its round.
[[nodiscard]] std::vector<EntryTimes> measure_rounds(const Group& group, std::uint64_t seed,
                                                     const Visit& visit);

}  // namespace thinbench
