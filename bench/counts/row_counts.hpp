// How many instructions one call of a row executes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "counts/callgrind.hpp"
#include "measure/timed_row.hpp"

namespace thinbench {

/// Why a row was skipped that another build may count.
inline constexpr const char* kTooManySteps = "more steps than are counted";

/// How a row was counted. Both agree but for the C library, which chooses other functions under
/// callgrind, and for instructions that repeat themselves, which callgrind counts each time.
enum class Method : std::uint8_t { single_steps, callgrind };

[[nodiscard]] constexpr const char* method_name(Method method) {
  return method == Method::callgrind ? "callgrind" : "single_steps";
}

struct RowCount {
  const TimedRow* row;
  std::uint64_t instructions;  // of one call
  Method method = Method::single_steps;
};

struct RowCounts {
  std::vector<RowCount> rows;
  std::vector<SkippedRow> skipped;
  CallgrindUse callgrind = {};
};

/// Counts single steps in a child process, which has made the row ready and called it once before:
/// memory lies alike whatever was counted earlier. None where a call takes more than `max_steps`.
/// Throws std::runtime_error where the child fails.
[[nodiscard]] std::optional<std::uint64_t> count_of(const TimedRow& row, std::uint64_t max_steps);

/// All these rows, of one input, which outlive the counts: by callgrind where it knows them, else
/// by single steps, for which a row is too long where its time says so, by far.
[[nodiscard]] RowCounts counts_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps);

}  // namespace thinbench
