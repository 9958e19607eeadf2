// What bounds a row: the instructions that it has to issue; and the images to count them on, small,
// because every instruction takes microseconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "counts/row_counts.hpp"
#include "measure/inputs.hpp"

namespace thinbench {

/// Every 5th pixel of every 16th row, named "<input>_small": the scene becomes 102 x 26 pixels,
/// more than a word in a row and few rows, with all its parts and most of their holes.
[[nodiscard]] TimedInput small_copy(const TimedInput& input);

/// At most `rows` rows from the middle, named "<input>_<rows>_rows".
[[nodiscard]] TimedInput middle_rows(const TimedInput& input, Index rows);

/// Both on the clock of the thread's processor time, measured next to each other.
struct CallTime {
  double seconds;            // of one call, the minimum of a few
  double seconds_per_cycle;  // of the core
};

[[nodiscard]] CallTime time_of(const TimedRow& row);

struct RowLimit {
  RowCount count;
  CallTime time;

  [[nodiscard]] double instructions_per_cycle() const {
    return static_cast<double>(count.instructions) * time.seconds_per_cycle / time.seconds;
  }
  /// No core that issues so many instructions per cycle takes less.
  [[nodiscard]] double limit_seconds(double issue_width) const {
    return static_cast<double>(count.instructions) / issue_width * time.seconds_per_cycle;
  }
};

struct Limits {
  std::vector<RowLimit> rows;
  std::vector<SkippedRow> skipped;
  CallgrindUse callgrind = {};
};

/// Of each case the row that takes the least time end to end, and no other.
[[nodiscard]] std::vector<TimedRow> fastest_rows(const std::vector<TimedRow>& rows);

/// Times and then counts rows, of one input, which outlive the limits. A row whose time makes more
/// than `max_steps` instructions likely, or far more than that for callgrind, is skipped:
/// counting takes hundreds or thousands of times as long as running.
[[nodiscard]] Limits limits_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps);

}  // namespace thinbench
