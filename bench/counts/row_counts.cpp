#include "counts/row_counts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <new>
#include <stdexcept>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "counts/counted_job.hpp"
#include "counts/single_steps.hpp"
#include "measure/known_rows.hpp"
#include "measure/probe.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

/// What the child says, in memory that it shares.
struct Answer {
  std::optional<std::uint64_t> instructions;  // none where the call takes too many steps
  std::array<char, 1000> why_not{};           // empty where it could be counted
};

void count_in_child(const TimedRow& row, std::uint64_t max_steps, Answer& answer) {
  try {
    with_warm_call(row, [&](const CountedCall& call) {
      answer.instructions = instructions_of(call, max_steps);
    });
  } catch (const std::exception& error) {
    std::snprintf(answer.why_not.data(), answer.why_not.size(), "%s", error.what());
  }
}

std::string end_of(int status) {
  return "the process that counts ended with " +
         (WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                              : "status " + std::to_string(WEXITSTATUS(status)));
}

/// Whether a call takes so many cycles that its steps need not be tried. The bound is far: a row
/// that is counted in one run must not be skipped in the next because the core was busy.
bool is_far_too_long(const TimedRow& row, double seconds_per_cycle, std::uint64_t max_steps) {
  constexpr double kMinInstructionsPerCycle = 0.5;
  return kMinInstructionsPerCycle * calibrate(row).seconds / seconds_per_cycle >
         static_cast<double>(max_steps);
}

/// The least of a few milliseconds.
double seconds_per_cycle() {
  constexpr int kSamples = 400;
  double shortest = cycle_ns();
  for (int sample = 1; sample < kSamples; ++sample) shortest = std::min(shortest, cycle_ns());
  return 1e-9 * shortest;
}

using Rows = std::vector<const TimedRow*>;
using Counted = std::map<const TimedRow*, RowCount>;

/// Variants whose kernel takes too many steps are not tried end to end.
void step_through(const Rows& rows, std::uint64_t max_steps, Counted& counted) {
  const double cycle = seconds_per_cycle();
  const Variant* too_long = nullptr;
  Progress progress("counting", static_cast<double>(rows.size()));
  for (const TimedRow* row : rows) {
    std::optional<std::uint64_t> instructions;
    if (row->variant != too_long && !is_far_too_long(*row, cycle, max_steps)) {
      instructions = count_of(*row, max_steps);
    }
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
Counted counted_in_two_ways(const Rows& rows, std::uint64_t max_steps, CallgrindUse& use) {
  const auto is_known = [](const TimedRow* row) { return callgrind_knows(*row); };
  const Rows known = those_that(rows, is_known);
  CallgrindRun callgrind(known);
  Counted counted;
  step_through(those_that(rows, std::not_fn(is_known)), max_steps, counted);
  const CallgrindCounts counts = callgrind.counts();
  use = counts.use;
  for (const auto& [row, instructions] : counts.instructions) {
    counted[row] = {row, instructions, Method::callgrind};
  }
  const auto is_left = [&](const TimedRow* row) { return !counted.contains(row); };
  step_through(those_that(known, is_left), max_steps, counted);
  return counted;
}

}  // namespace

/// The child ends without the destructors and buffers of the parent, whose copies these are.
std::optional<std::uint64_t> count_of(const TimedRow& row, std::uint64_t max_steps) {
  void* const memory =
      mmap(nullptr, sizeof(Answer), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw_errno("no memory to count in");
  auto* const shared = new (memory) Answer;
  const pid_t child = fork();
  if (child < 0) throw_errno("no process to count in");
  if (child == 0) {
    count_in_child(row, max_steps, *shared);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  const Answer answer = *shared;
  munmap(memory, sizeof(Answer));
  const std::string why_not = status == 0 ? answer.why_not.data() : end_of(status);
  if (why_not.empty()) return answer.instructions;
  throw std::runtime_error("instructions of " + row.name + " cannot be counted: " + why_not);
}

RowCounts counts_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps) {
  Rows all;
  for (const TimedRow& row : rows) all.push_back(&row);
  RowCounts counts;
  const Counted counted = counted_in_two_ways(all, max_steps, counts.callgrind);
  for (const TimedRow* row : all) {
    const auto found = counted.find(row);
    if (found != counted.end()) {
      counts.rows.push_back(found->second);
    } else {
      counts.skipped.push_back({row->name, kTooManySteps});
    }
  }
  return counts;
}

}  // namespace thinbench
