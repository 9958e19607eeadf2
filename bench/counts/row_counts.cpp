#include "counts/row_counts.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <system_error>

#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "counts/counted_job.hpp"
#include "counts/single_steps.hpp"
#include "measure/known_rows.hpp"
#include "measure/probe.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// What the child says: {} where the call takes too many steps.
Json answer_of(const TimedRow& row, std::uint64_t max_steps) {
  Json answer = Json::object();
  try {
    with_warm_call(row, [&](const CountedCall& call) {
      if (const auto count = instructions_of(call, max_steps)) answer["instructions"] = *count;
    });
  } catch (const std::exception& error) {
    answer = {{"why_not", error.what()}};
  }
  return answer;
}

int write_to(int pipe_end, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(pipe_end, text.data() + done, text.size() - done);
    if (written <= 0) return 1;
    done += static_cast<std::size_t>(written);
  }
  return 0;
}

std::string read_from(int pipe_end) {
  std::string text;
  std::array<char, 4096> more{};
  for (ssize_t got = 0; (got = read(pipe_end, more.data(), more.size())) > 0;) {
    text.append(more.data(), static_cast<std::size_t>(got));
  }
  return text;
}

std::string end_of(int status) {
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  return "status " + std::to_string(WEXITSTATUS(status));
}

/// The child ends without the destructors and buffers of the parent, whose copies these are.
Json answer_of_child(const TimedRow& row, std::uint64_t max_steps) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw_errno("no pipe");
  const pid_t child = fork();
  if (child < 0) throw_errno("no process to count in");
  if (child == 0) _exit(write_to(ends[1], answer_of(row, max_steps).dump()));
  close(ends[1]);
  Json answer = Json::parse(read_from(ends[0]), nullptr, false);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  const bool has_ended = answer.is_object() && status == 0;
  const std::string why_not = has_ended ? answer.value("why_not", "")
                                        : "the process that counts ended with " + end_of(status);
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

std::optional<std::uint64_t> count_of(const TimedRow& row, std::uint64_t max_steps) {
  const Json answer = answer_of_child(row, max_steps);
  if (answer.empty()) return std::nullopt;
  return answer.at("instructions").get<std::uint64_t>();
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
