#include "counts/limits.hpp"

#include <map>
#include <optional>

#include "counts/call_time.hpp"
#include "counts/cycles.hpp"
#include "timing/progress.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kEpochs = 9;

/// What fast rows reach at least; slow ones reach less and are left out all the same.
constexpr double kExpectedInstructionsACycle = 3;

bool is_too_long(const CallTime& time, std::uint64_t most_steps) {
  return kExpectedInstructionsACycle * time.seconds / time.seconds_a_cycle >
         static_cast<double>(most_steps);
}

}  // namespace

CallTime time_of(const TimedRow& row) {
  const double cycle = seconds_a_cycle();
  return {seconds_of_call(row, kEpochs), cycle};
}

std::vector<TimedRow> fastest_rows(const std::vector<TimedRow>& rows) {
  struct Best {
    double seconds;
    const TimedRow* row;
  };
  std::map<const Operation*, Best> best;
  for (const TimedRow& row : rows) {
    if (row.scope != Scope::kEndToEnd) continue;
    const Best one = {seconds_of_call(row, 1), &row};
    const auto [place, is_first] = best.try_emplace(row.operation, one);
    if (!is_first && one.seconds < place->second.seconds) place->second = one;
  }
  std::vector<TimedRow> fastest;
  for (const TimedRow& row : rows) {
    const auto found = best.find(row.operation);
    if (found != best.end() && found->second.row == &row) fastest.push_back(row);
  }
  return fastest;
}

Limits limits_of(const std::vector<TimedRow>& rows, std::uint64_t most_steps) {
  Limits limits;
  Progress progress("counting", static_cast<double>(rows.size()));
  for (const TimedRow& row : rows) {
    progress.advance(1);
    const CallTime time = time_of(row);
    std::optional<std::uint64_t> instructions;
    if (!is_too_long(time, most_steps)) instructions = count_of(row, most_steps);
    if (instructions) {
      limits.rows.push_back({{&row, *instructions}, time});
    } else {
      limits.skipped.push_back({row.name, kTooManySteps});
    }
  }
  return limits;
}

}  // namespace thinbench
