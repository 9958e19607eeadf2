#include "counts/row_counts.hpp"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <sys/wait.h>
#include <unistd.h>

#include "counts/call_time.hpp"
#include "counts/cycles.hpp"
#include "counts/single_steps.hpp"
#include "counts/warm_call.hpp"
#include "timing/progress.hpp"

namespace thinbench {
namespace {

/// What the child says of its call.
struct Answer {
  std::uint64_t instructions = 0;
  bool finished = false;  // within the steps it had
};

Answer answer_of(const TimedRow& row, std::uint64_t most_steps) {
  std::optional<std::uint64_t> instructions;
  with_warm_call(
      row, [&](const CountedCall& call) { instructions = instructions_of(call, most_steps); });
  return {instructions.value_or(0), instructions.has_value()};
}

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// What went wrong shows in the status.
int answer_into(int pipe_end, const TimedRow& row, std::uint64_t most_steps) {
  try {
    const Answer answer = answer_of(row, most_steps);
    return write(pipe_end, &answer, sizeof answer) == sizeof answer ? 0 : 1;
  } catch (...) {
    return 1;
  }
}

/// Ends without the destructors and buffers of the parent, whose copies these are.
[[noreturn]] void answer_and_exit(const TimedRow& row, std::uint64_t most_steps, int pipe_end) {
  _exit(answer_into(pipe_end, row, most_steps));
}

std::string end_of(int status) {
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  return "status " + std::to_string(WEXITSTATUS(status));
}

Answer answer_of_child(const TimedRow& row, std::uint64_t most_steps) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw_errno("no pipe");
  const pid_t child = fork();
  if (child < 0) throw_errno("no process to count in");
  if (child == 0) answer_and_exit(row, most_steps, ends[1]);
  close(ends[1]);
  Answer answer;
  const bool whole = read(ends[0], &answer, sizeof answer) == sizeof answer;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (whole && status == 0) return answer;
  throw std::runtime_error("instructions of " + row.name +
                           " cannot be counted: the process that counts ended with " +
                           end_of(status));
}

/// Whether a call takes so many cycles that its steps need not be tried. The bound is far: a row
/// that is counted in one run must not be passed over in the next because the core was busy.
bool is_far_too_long(const TimedRow& row, double seconds_a_cycle, std::uint64_t most_steps) {
  constexpr double kLeastInstructionsACycle = 0.5;
  return kLeastInstructionsACycle * seconds_of_call(row, 1) / seconds_a_cycle >
         static_cast<double>(most_steps);
}

}  // namespace

std::optional<std::uint64_t> count_of(const TimedRow& row, std::uint64_t most_steps) {
  const Answer answer = answer_of_child(row, most_steps);
  if (!answer.finished) return std::nullopt;
  return answer.instructions;
}

std::vector<const TimedRow*> rows_for_callgrind(const std::vector<TimedRow>& rows) {
  std::vector<const TimedRow*> known;
  for (const TimedRow& row : rows) {
    if (callgrind_knows(row)) known.push_back(&row);
  }
  return known;
}

RowCounts counts_of(const std::vector<TimedRow>& rows, std::uint64_t most_steps) {
  const CallgrindCounts callgrind = callgrind_counts(rows_for_callgrind(rows));
  RowCounts counts;
  counts.callgrind = callgrind.use;
  const double cycle = seconds_a_cycle();
  const Variant* too_long = nullptr;
  Progress progress("counting", static_cast<double>(rows.size()));
  for (const TimedRow& row : rows) {
    progress.advance(1);
    if (const auto instructions = callgrind.of(row)) {
      counts.rows.push_back({&row, *instructions, Method::kCallgrind});
      continue;
    }
    std::optional<std::uint64_t> instructions;
    if (row.variant != too_long && !is_far_too_long(row, cycle, most_steps)) {
      instructions = count_of(row, most_steps);
    }
    if (instructions) {
      counts.rows.push_back({&row, *instructions});
    } else {
      too_long = row.variant;
      counts.skipped.push_back({row.name, kTooManySteps});
    }
  }
  return counts;
}

}  // namespace thinbench
