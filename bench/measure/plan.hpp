// What is measured and how often: decided once, before the first process, and the same for all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "measure/inputs.hpp"
#include "measure/timed_row.hpp"

namespace thinbench {

/// Seconds that an epoch of short calls lasts.
inline constexpr double kEpoch = 0.0003;
/// Calls longer than this warm themselves up.
inline constexpr double kSlowCall = 0.005;

enum class Role {
  row,
  same,    // A/A control: a row again
  slowed,  // control with an injected slowdown of 10 %
};

/// What is timed.
struct Entry {
  std::string name;  // of the row; controls share it with theirs
  Role role = Role::row;
  std::int64_t calls = 1;    // in an epoch
  double delay_ns = 0;       // injected, for each call
  std::int64_t warm_up = 0;  // untimed calls before each epoch
  int visits = 1;            // epochs in each layout
  bool threaded = false;
  double seconds = 0;  // expected, for all visits in all layouts
  std::string hash;    // of the verified result
};

/// The rows of one case on one input, whose epochs are interleaved.
struct Group {
  std::vector<Entry> entries;
  int layouts = 3;  // how often a process makes the jobs again, at other addresses
};

/// All that measuring processes and the reader of their samples have to know.
struct Plan {
  InputChoice inputs;
  double cycle_ns = 0;  // the clock cycle that times are given at
  std::vector<Group> groups;
};

struct PlanLimits {
  double seconds_per_row = 0.003;  // in each process; every row has an epoch in each layout
  double max_call_seconds = 1;     // slower rows are verified, but not measured
};

/// A row with the time of its fastest call.
struct CalibratedRow {
  const TimedRow* row;
  double seconds;
  std::string hash;
};

/// Calls the row a few times.
[[nodiscard]] CalibratedRow calibrate(const TimedRow& row);

/// Plans rows of one case and input. The controls repeat the fastest of the project's rows on one
/// thread.
[[nodiscard]] Group plan_group(const std::vector<CalibratedRow>& rows, const PlanLimits& limits);

}  // namespace thinbench
