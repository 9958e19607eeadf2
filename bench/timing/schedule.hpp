// How often a row runs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "timing/timed_row.hpp"

namespace thinbench {

struct Schedule {
  std::int64_t iterations;  // a repetition
  int repetitions;
  bool warm_up;  // one more call, untimed, before each repetition
  double seconds_a_repetition;
};

/// Repetitions of about `seconds`, as many as asked for; for slow calls a third of them, but no
/// fewer than three unless fewer were asked for.
[[nodiscard]] inline Schedule schedule_of(double seconds_of_a_call, int repetitions,
                                          double seconds) {
  const double one = std::max(seconds_of_a_call, 1e-7);
  const bool slow = one > kSlowCall;
  const auto iterations = std::max<std::int64_t>(1, std::llround(seconds / one));
  const int fewer = std::max(std::min(3, repetitions), repetitions / 3);
  const auto calls = static_cast<double>(iterations + (slow ? 0 : 1));
  return {iterations, slow ? fewer : repetitions, !slow, calls * one};
}

}  // namespace thinbench
