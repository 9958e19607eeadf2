#include "counts/row_counts.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <system_error>

#include <sys/wait.h>
#include <unistd.h>

#include "counts/counted_job.hpp"
#include "counts/single_steps.hpp"
#include "measure/measuring.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

/// What the child reports of its call.
struct Answer {
  std::uint64_t instructions = 0;
  bool finished = false;  // within the steps it had
  std::array<char, 200> why_not{};
};

Answer answer_of(const TimedRow& row, std::uint64_t max_steps) {
  std::optional<std::uint64_t> instructions;
  with_warm_call(row,
                 [&](const CountedCall& call) { instructions = instructions_of(call, max_steps); });
  return {instructions.value_or(0), instructions.has_value(), {}};
}

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

int answer_into(int pipe_end, const TimedRow& row, std::uint64_t max_steps) {
  Answer answer;
  try {
    answer = answer_of(row, max_steps);
  } catch (const std::exception& error) {
    std::strncpy(answer.why_not.data(), error.what(), answer.why_not.size() - 1);
  }
  return write(pipe_end, &answer, sizeof answer) == sizeof answer ? 0 : 1;
}

/// Ends without the destructors and buffers of the parent, whose copies these are.
[[noreturn]] void answer_and_exit(const TimedRow& row, std::uint64_t max_steps, int pipe_end) {
  _exit(answer_into(pipe_end, row, max_steps));
}

std::string end_of(int status) {
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  return "status " + std::to_string(WEXITSTATUS(status));
}

Answer answer_of_child(const TimedRow& row, std::uint64_t max_steps) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw_errno("no pipe");
  const pid_t child = fork();
  if (child < 0) throw_errno("no process to count in");
  if (child == 0) answer_and_exit(row, max_steps, ends[1]);
  close(ends[1]);
  Answer answer;
  const bool whole = read(ends[0], &answer, sizeof answer) == sizeof answer;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  const bool has_ended = whole && status == 0;
  const std::string why_not =
      has_ended ? answer.why_not.data() : "the process that counts ended with " + end_of(status);
  if (why_not.empty()) return answer;
  throw std::runtime_error("instructions of " + row.name + " cannot be counted: " + why_not);
}

/// Whether a call takes so many cycles that its steps need not be tried. The bound is far: a row
/// that is counted in one run must not be skipped in the next because the core was busy.
bool is_far_too_long(const TimedRow& row, double seconds_per_cycle, std::uint64_t max_steps) {
  constexpr double kMinInstructionsPerCycle = 0.5;
  return kMinInstructionsPerCycle * calibrate(row).seconds / seconds_per_cycle >
         static_cast<double>(max_steps);
}

using Rows = std::vector<const TimedRow*>;
using Counted = std::map<const TimedRow*, RowCount>;

void step_through(const Rows& rows, std::uint64_t max_steps, const IsTooLong& is_too_long,
                  Counted& counted) {
  const Variant* too_long = nullptr;
  Progress progress("counting", static_cast<double>(rows.size()));
  for (const TimedRow* row : rows) {
    std::optional<std::uint64_t> instructions;
    if (row->variant != too_long && !is_too_long(*row)) instructions = count_of(*row, max_steps);
    if (instructions) {
      counted[row] = {row, *instructions, Method::single_steps};
    } else {
      too_long = row->variant;
    }
    progress.advance(1);
  }
}

template <class Is>
Rows those_that(const Rows& rows, const Is& is) {
  Rows chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), is);
  return chosen;
}

/// Callgrind runs beside the single steps of what it does not know; what it should have counted and
/// did not is stepped through, too.
Counted counted_in_two_ways(const Rows& rows, std::uint64_t max_steps, const IsTooLong& is_too_long,
                            CallgrindUse& use) {
  const auto is_known = [](const TimedRow* row) { return callgrind_knows(*row); };
  const Rows known = those_that(rows, is_known);
  CallgrindRun callgrind(known);
  Counted counted;
  step_through(those_that(rows, std::not_fn(is_known)), max_steps, is_too_long, counted);
  const CallgrindCounts counts = callgrind.counts();
  use = counts.use;
  for (const auto& [row, instructions] : counts.instructions) {
    counted[row] = {row, instructions, Method::callgrind};
  }
  const auto is_left = [&](const TimedRow* row) { return !counted.contains(row); };
  step_through(those_that(known, is_left), max_steps, is_too_long, counted);
  return counted;
}

}  // namespace

std::optional<std::uint64_t> count_of(const TimedRow& row, std::uint64_t max_steps) {
  const Answer answer = answer_of_child(row, max_steps);
  if (!answer.finished) return std::nullopt;
  return answer.instructions;
}

RowCounts counts_of(const std::vector<const TimedRow*>& rows, std::uint64_t max_steps,
                    const IsTooLong& is_too_long) {
  RowCounts counts;
  const Counted counted = counted_in_two_ways(rows, max_steps, is_too_long, counts.callgrind);
  for (const TimedRow* row : rows) {
    const auto found = counted.find(row);
    if (found != counted.end()) {
      counts.rows.push_back(found->second);
    } else {
      counts.skipped.push_back({row->name, kTooManySteps});
    }
  }
  return counts;
}

RowCounts counts_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps) {
  Rows all;
  for (const TimedRow& row : rows) all.push_back(&row);
  const double cycle = machine_state().chain_ns * 1e-9;
  return counts_of(all, max_steps,
                   [&](const TimedRow& row) { return is_far_too_long(row, cycle, max_steps); });
}

}  // namespace thinbench
