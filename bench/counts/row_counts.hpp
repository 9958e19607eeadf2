// How many instructions one call of a row executes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "timing/timed_row.hpp"

namespace thinbench {

/// Why a row was skipped that another build may count.
inline constexpr const char* kTooManySteps = "more steps than are counted";

struct RowCount {
  const TimedRow* row;
  std::uint64_t instructions;  // of one call
};

struct RowCounts {
  std::vector<RowCount> rows;
  std::vector<SkippedRow> skipped;
};

/// Counts in a child process, which has made the row ready and called it once before: memory lies
/// alike whatever was counted earlier. None where a call takes more than `most_steps`. Throws
/// std::runtime_error where the child fails.
[[nodiscard]] std::optional<std::uint64_t> count_of(const TimedRow& row, std::uint64_t most_steps);

/// All these rows, which outlive the counts. A variant whose kernel takes too many steps is not
/// tried end to end.
[[nodiscard]] RowCounts counts_of(const std::vector<TimedRow>& rows, std::uint64_t most_steps);

}  // namespace thinbench
