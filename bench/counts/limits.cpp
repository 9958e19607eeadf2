#include "counts/limits.hpp"

#include <map>
#include <optional>

#include "counts/call_time.hpp"
#include "counts/cycles.hpp"
#include "measure/progress.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kEpochs = 9;

/// What fast rows reach at least; slow ones reach less and are left out all the same.
constexpr double kExpectedInstructionsACycle = 3;

/// Callgrind counts hundreds of them while one is stepped over.
constexpr std::uint64_t kUnderCallgrindForAStep = 250;

bool is_too_long(const CallTime& time, std::uint64_t most_instructions) {
  return kExpectedInstructionsACycle * time.seconds / time.seconds_a_cycle >
         static_cast<double>(most_instructions);
}

using Times = std::map<const TimedRow*, CallTime>;

Times times_of(const std::vector<TimedRow>& rows) {
  Times times;
  Progress progress("timing", static_cast<double>(rows.size()));
  for (const TimedRow& row : rows) {
    times[&row] = time_of(row);
    progress.advance(1);
  }
  return times;
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
    if (row.scope != Scope::end_to_end) continue;
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
  const Times times = times_of(rows);
  Limits limits;
  std::vector<const TimedRow*> countable;
  for (const TimedRow& row : rows) {
    const std::uint64_t factor = callgrind_knows(row) ? kUnderCallgrindForAStep : 1;
    if (!is_too_long(times.at(&row), factor * most_steps)) {
      countable.push_back(&row);
    } else {
      limits.skipped.push_back({row.name, kTooManySteps});
    }
  }
  const RowCounts counts = counts_of(countable, most_steps, [&](const TimedRow& row) {
    return is_too_long(times.at(&row), most_steps);
  });
  for (const RowCount& count : counts.rows) limits.rows.push_back({count, times.at(count.row)});
  limits.skipped.insert(limits.skipped.end(), counts.skipped.begin(), counts.skipped.end());
  limits.callgrind = counts.callgrind;
  return limits;
}

}  // namespace thinbench
