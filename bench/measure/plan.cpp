#include "measure/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>

#include "measure/measuring.hpp"
#include "measure/timed_call.hpp"

namespace thinbench {
namespace {

using Rows = std::vector<CalibratedRow>;

constexpr int kMinRounds = 3;
constexpr int kMinSweeps = 2;
/// Short calls are visited more often in a round that long calls dominate.
constexpr int kMaxSweeps = 12;

Entry entry_of(const CalibratedRow& row) {
  Entry entry;
  entry.name = row.row->name;
  entry.threaded = row.row->threads > 1;
  entry.hash = row.hash;
  entry.long_call = row.seconds > kLongCall;
  if (!entry.long_call) {
    entry.calls = std::max<std::int64_t>(1, std::llround(kEpoch / std::max(row.seconds, 1e-8)));
  }
  entry.counted = entry.calls;
  // Another row has left caches and branch predictor in its own state.
  if (row.seconds <= kSlowCall) entry.warm_up = entry.long_call ? 1 : 1 + entry.calls / 3;
  return entry;
}

/// The fastest of the project's own rows on one thread, other than `excluded`.
std::optional<std::size_t> fastest(const Rows& rows, std::optional<std::size_t> excluded = {}) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TimedRow& row = *rows[i].row;
    if (row.variant == nullptr || row.is_peer() || row.threads > 1 || i == excluded) continue;
    if (!best || rows[i].seconds < rows[*best].seconds) best = i;
  }
  return best;
}

/// What the controls repeat. Not the anchor, if possible: between two epochs of its own a row finds
/// its data in the cache and is up to 3 % faster.
std::size_t control_row(const Rows& rows, std::size_t anchor) {
  const auto other = fastest(rows, anchor);
  return other && rows[*other].seconds <= kLongCall ? *other : anchor;
}

void add_controls(std::size_t base, Group& group) {
  Entry same = group.entries[base];
  same.role = Role::same;
  Entry slowed = same;
  slowed.role = Role::slowed;
  slowed.counted = 10 * std::max<std::int64_t>(1, same.calls / 10);
  slowed.calls = slowed.counted / 10 * 11;
  group.entries.push_back(std::move(same));
  group.entries.push_back(std::move(slowed));
}

/// Chooses sweeps and rounds such that all rounds take `budget` seconds.
void schedule(const Rows& rows, double budget, int max_rounds, Group& group) {
  const auto epoch_seconds = [&](const Entry& entry) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const CalibratedRow& candidate) {
      return candidate.row->name == entry.name;
    });
    return static_cast<double>(entry.calls + entry.warm_up) * row->seconds;
  };
  const double anchor = epoch_seconds(group.entries[group.anchor]);
  double long_calls = 0;
  double sweep = 0;
  for (const Entry& entry : group.entries) {
    (entry.long_call ? long_calls : sweep) += epoch_seconds(entry) + (entry.long_call ? 0 : anchor);
  }
  sweep = std::max(sweep, anchor);
  const auto sweeps = static_cast<int>(std::min(long_calls / sweep, 1.0 * kMaxSweeps));
  group.sweeps = std::max(kMinSweeps, sweeps);
  const double round = long_calls + group.sweeps * sweep;
  const double affordable = std::min(budget / round, 1.0 * max_rounds);
  group.rounds = std::max(std::min(kMinRounds, max_rounds), static_cast<int>(affordable));
  group.seconds = group.rounds * round;
}

int more_calls(double seconds) {
  constexpr double kLongerThanInterruptions = 0.1;
  if (seconds > kLongerThanInterruptions) return 0;
  return seconds > kSlowCall ? 1 : 5;
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
  for (const CalibratedRow& row : rows) group.entries.push_back(entry_of(row));
  group.anchor = fastest(rows).value_or(0);
  add_controls(control_row(rows, group.anchor), group);
  const double budget = limits.seconds_per_row * static_cast<double>(rows.size());
  schedule(rows, budget, limits.max_rounds, group);
  return group;
}

}  // namespace thinbench
