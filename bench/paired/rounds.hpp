// Rounds: every epoch of a short call stands between two epochs of the anchor, A B A, so that
// neither a drift nor a neighbour who comes and goes stays in the ratio.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "paired/plan.hpp"

namespace thinbench {

/// On both clocks, in nanoseconds.
struct Times {
  double thread_cpu = 0;
  double wall = 0;
};

/// Makes the calls of an epoch and returns how long they took together.
using Visit = std::function<Times(std::size_t entry)>;

/// One entry on one clock.
struct ClockTimes {
  std::vector<double> logs;  // ln(time / anchor's time), visit by visit; one 0 for the anchor
  double ns = 0;             // a counted call, median over the visits
};

struct EntryTimes {
  ClockTimes thread_cpu;
  ClockTimes wall;
};

/// 0 .. n - 1 in an order that depends on the seed alone.
[[nodiscard]] std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed);

/// A round is half of the sweeps, the long calls, once, and the other half. A sweep visits the
/// short calls in random order, the anchor before, between and after. What takes longer than the
/// neighbourhood that two epochs could tell of, a long call, is compared with the median of all
/// epochs of the anchor in its round.
[[nodiscard]] std::vector<EntryTimes> measure_rounds(const Group& group, std::uint64_t seed,
                                                     const Visit& visit);

}  // namespace thinbench
