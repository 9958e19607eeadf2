#include "measure/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "measure/measuring.hpp"
#include "measure/timed_call.hpp"

namespace thinbench {
namespace {

using Rows = std::vector<CalibratedRow>;

constexpr int kMaxVisits = 15;

/// Visits are chosen such that they take the time that a row has.
Entry entry_of(const CalibratedRow& row, const PlanLimits& limits, int layouts) {
  Entry entry;
  entry.name = row.row->name;
  entry.threaded = row.row->threads > 1;
  entry.hash = row.hash;
  entry.calls = std::max<std::int64_t>(1, std::llround(kEpoch / std::max(row.seconds, 1e-8)));
  // Another row has left caches and branch predictor in its own state.
  if (row.seconds <= kSlowCall) entry.warm_up = 1 + entry.calls / 3;
  const double epoch = static_cast<double>(entry.calls + entry.warm_up) * row.seconds * layouts;
  entry.visits = static_cast<int>(
      std::clamp(limits.seconds_per_row / std::max(epoch, 1e-9), 1.0, 1.0 * kMaxVisits));
  entry.seconds = entry.visits * epoch;
  return entry;
}

/// The fastest of the project's own rows on one thread; the first row where there is none.
std::size_t fastest(const Rows& rows) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TimedRow& row = *rows[i].row;
    if (row.variant == nullptr || row.is_peer() || row.threads > 1) continue;
    if (!best || rows[i].seconds < rows[*best].seconds) best = i;
  }
  return best.value_or(0);
}

void add_controls(const Rows& rows, Group& group) {
  const std::size_t base = fastest(rows);
  Entry same = group.entries[base];
  same.role = Role::same;
  Entry slowed = same;
  slowed.role = Role::slowed;
  constexpr double kSlowdown = 0.1;
  slowed.delay_ns = kSlowdown * 1e9 * rows[base].seconds;
  slowed.seconds *= 1 + kSlowdown;
  group.entries.push_back(std::move(same));
  group.entries.push_back(std::move(slowed));
}

int more_calls(double seconds) {
  constexpr double kLongerThanInterruptions = 0.1;
  constexpr double kEnough = 0.003;
  if (seconds > kLongerThanInterruptions) return 0;
  return seconds > kSlowCall ? 1 : static_cast<int>(std::clamp(kEnough / seconds, 5.0, 300.0));
}

}  // namespace

/// The minimum counts: an interrupted call would make epochs of too few calls, in which a row seems
/// slower by half and more. The first call also touches every page.
CalibratedRow calibrate(const TimedRow& row) {
  TimedCall call(row);
  const auto timed = [&] {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  double seconds = timed();
  for (int i = more_calls(seconds); i > 0; --i) seconds = std::min(seconds, timed());
  return {&row, seconds, hash_of(call.outcome())};
}

Group plan_group(const Rows& rows, const PlanLimits& limits) {
  Group group;
  for (const CalibratedRow& row : rows) {
    group.entries.push_back(entry_of(row, limits, group.layouts));
  }
  add_controls(rows, group);
  return group;
}

}  // namespace thinbench
