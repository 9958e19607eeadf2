#include "counts/limits.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "measure/measuring.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

constexpr Index kAcross = 5;
constexpr Index kDown = 16;

ByteImage small_copy_of(const ByteImage& image) {
  ByteImage few((image.width() + kAcross - 1) / kAcross, (image.height() + kDown - 1) / kDown);
  for (Index y = 0; y < few.height(); ++y) {
    for (Index x = 0; x < few.width(); ++x) few.at(x, y) = image.at(x * kAcross, y * kDown);
  }
  return few;
}

ByteImage rows_of(const ByteImage& image, Index first, Index count) {
  ConstImageView rows = image.view();
  rows.data += first * rows.stride;
  rows.height = count;
  return copy_of(rows);
}

}  // namespace

TimedInput small_copy(const TimedInput& input) {
  return {input.name + "_small", small_copy_of(input.binary), small_copy_of(input.grey)};
}

TimedInput middle_rows(const TimedInput& input, Index rows) {
  const Index count = std::min(rows, input.height());
  const Index first = (input.height() - count) / 2;
  return {input.name + "_" + std::to_string(count) + "_rows", rows_of(input.binary, first, count),
          rows_of(input.grey, first, count)};
}

namespace {

/// What fast rows reach; slow ones reach less and are skipped anyway.
constexpr double kExpectedInstructionsPerCycle = 3;

/// Callgrind counts hundreds of them while one is stepped over.
constexpr std::uint64_t kUnderCallgrindPerStep = 250;

bool is_too_long(const CallTime& time, std::uint64_t most_instructions) {
  return kExpectedInstructionsPerCycle * time.seconds / time.seconds_per_cycle >
         static_cast<double>(most_instructions);
}

using RowTimes = std::map<const TimedRow*, CallTime>;

RowTimes times_of(const std::vector<TimedRow>& rows) {
  RowTimes times;
  Progress progress("timing", static_cast<double>(rows.size()));
  for (const TimedRow& row : rows) {
    times[&row] = time_of(row);
    progress.advance(1);
  }
  return times;
}

}  // namespace

CallTime time_of(const TimedRow& row) {
  const double cycle = machine_state().chain_ns * 1e-9;  // of a dependent addition: one cycle
  return {calibrate(row).seconds, cycle};
}

std::vector<TimedRow> fastest_rows(const std::vector<TimedRow>& rows) {
  struct Best {
    double seconds;
    const TimedRow* row;
  };
  std::map<const Operation*, Best> best;
  for (const TimedRow& row : rows) {
    if (row.scope != Scope::end_to_end) continue;
    const Best one = {calibrate(row).seconds, &row};
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

Limits limits_of(const std::vector<TimedRow>& rows, std::uint64_t max_steps) {
  const RowTimes times = times_of(rows);
  Limits limits;
  std::vector<const TimedRow*> countable;
  for (const TimedRow& row : rows) {
    const std::uint64_t factor = callgrind_knows(row) ? kUnderCallgrindPerStep : 1;
    if (!is_too_long(times.at(&row), factor * max_steps)) {
      countable.push_back(&row);
    } else {
      limits.skipped.push_back({row.name, kTooManySteps});
    }
  }
  const RowCounts counts = counts_of(countable, max_steps, [&](const TimedRow& row) {
    return is_too_long(times.at(&row), max_steps);
  });
  for (const RowCount& count : counts.rows) limits.rows.push_back({count, times.at(count.row)});
  limits.skipped.insert(limits.skipped.end(), counts.skipped.begin(), counts.skipped.end());
  limits.callgrind = counts.callgrind;
  return limits;
}

}  // namespace thinbench
