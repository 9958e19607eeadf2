// What the program that callgrind runs is told, and what it answers: plain text and pixels.
#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "measure/timed_row.hpp"

namespace thinbench {

/// Stands beside every program that counts, where it was built.
inline constexpr const char* kCountedCallsProgram = "thinbench_counted_calls";

/// Answers, a line for each process: first an empty call, then the rows.
inline constexpr const char* kCallDone = "call done";
inline constexpr const char* kCallFailed = "call failed";

struct CountedJob {
  TimedInput input;
  std::vector<std::string> rows;  // case/technique/isa/threads/scope/input
};

void write_job(std::ostream& stream, const TimedInput& input, const std::vector<std::string>& rows);

/// Throws std::runtime_error where the stream holds less than a job.
[[nodiscard]] CountedJob read_job(std::istream& stream);

/// The row of this name on the job's input. Throws std::runtime_error where no operation has it or
/// it cannot run here.
[[nodiscard]] TimedRow row_named(const std::string& name, const TimedInput& input);

}  // namespace thinbench
