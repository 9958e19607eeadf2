// What rows execute, beside the clock cycles that they take; and the images to count on, small,
// because every instruction takes microseconds.
#pragma once

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

struct RowLimit {
  RowCode code;
  double seconds;  // of a call: its floor, on the clock that the cycle is measured on
};

struct Limits {
  double seconds_per_cycle = 0;  // of the core: one for all rows, the floor of the whole run
  std::vector<RowLimit> rows;
  std::vector<SkippedRow> skipped;

  [[nodiscard]] double cycles(const RowLimit& row) const { return row.seconds / seconds_per_cycle; }
  [[nodiscard]] double instructions_per_cycle(const RowLimit& row) const {
    return static_cast<double>(row.code.count.instructions) / cycles(row);
  }
};

/// Of each case the row that takes the least time end to end, and no other.
[[nodiscard]] std::vector<TimedRow> fastest_rows(const std::vector<TimedRow>& rows);

/// Times and then steps through rows, of one input, which outlive the limits. A row whose time
/// makes more than `max_steps` instructions likely is skipped: a step takes thousands of times as
/// long as an instruction.
[[nodiscard]] Limits limits_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps);

}  // namespace thinbench
