// What is measured and how often: decided once, before the first process, and the same for all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "measure/timed_row.hpp"

namespace thinbench {

/// Seconds that an epoch of short calls lasts. A call longer than kLongCall is an epoch by itself.
inline constexpr double kEpoch = 0.0003;
inline constexpr double kLongCall = 0.001;
/// Calls longer than this warm themselves up.
inline constexpr double kSlowCall = 0.005;

enum class Role {
  row,
  same,    // A/A control: a row again
  slowed,  // control with an injected slowdown of 10 %: 11 calls for every 10 that are counted
};

/// What a round visits.
struct Entry {
  std::string name;  // of the row; controls share it with theirs
  Role role = Role::row;
  std::int64_t calls = 1;    // in an epoch
  std::int64_t counted = 1;  // divisor of the epoch's time
  std::int64_t warm_up = 0;  // untimed calls before each epoch
  bool long_call = false;
  bool threaded = false;
  std::string hash;  // of the verified result
};

/// The rows of one case on one input, measured in common rounds.
struct Group {
  std::vector<Entry> entries;
  std::size_t anchor = 0;  // the entry that all others are measured beside
  int rounds = 0;
  int sweeps = 2;      // visits of the short calls in a round
  double seconds = 0;  // expected, for all rounds
};

struct PlanLimits {
  double seconds_per_row = 0.003;  // in each process
  int max_rounds = 41;
  double max_call_seconds = 1;  // slower rows are verified, but not measured
};

/// A row with the time of its fastest call.
struct CalibratedRow {
  const TimedRow* row;
  double seconds;
  std::string hash;
};

/// Calls the row a few times.
[[nodiscard]] CalibratedRow calibrate(const TimedRow& row);

/// Plans rows of one case and input. The anchor is the fastest of the project's rows on one thread;
/// the controls repeat the next fastest.
[[nodiscard]] Group plan_group(const std::vector<CalibratedRow>& rows, const PlanLimits& limits);

}  // namespace thinbench
