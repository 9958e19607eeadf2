// What bounds a row: the instructions that it has to issue.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "counts/row_counts.hpp"

namespace thinbench {

/// Both on the clock of the thread's processor time, measured next to each other.
struct CallTime {
  double seconds;          // of one call, the median of short epochs
  double seconds_a_cycle;  // of the core
};

[[nodiscard]] CallTime time_of(const TimedRow& row);

struct RowLimit {
  RowCount count;
  CallTime time;

  [[nodiscard]] double instructions_per_cycle() const {
    return static_cast<double>(count.instructions) * time.seconds_a_cycle / time.seconds;
  }
  /// No core that issues so many instructions per cycle takes less.
  [[nodiscard]] double limit_seconds(double issue_width) const {
    return static_cast<double>(count.instructions) / issue_width * time.seconds_a_cycle;
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
/// than `most_steps` instructions likely, or far more than that for callgrind, is left out untried:
/// counting takes hundreds or thousands of times as long as running.
[[nodiscard]] Limits limits_of(const std::vector<TimedRow>& rows, std::uint64_t most_steps);

}  // namespace thinbench
