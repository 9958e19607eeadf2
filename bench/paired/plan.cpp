#include "paired/plan.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace thinbench {
namespace {

using Rows = std::vector<CalibratedRow>;
using Wanted = std::function<bool(const TimedRow&)>;

std::int64_t calls_an_epoch(double seconds) {
  return std::max<std::int64_t>(1, std::llround(kEpoch / std::max(seconds, 1e-8)));
}

/// One call and a third of the epoch, as caches and branch predictor are left by another row. Slow
/// calls warm themselves.
std::int64_t warm_up_of(const CalibratedRow& row, std::int64_t calls) {
  if (row.seconds > kSlowCall) return 0;
  return row.seconds > kLongCall ? 1 : 1 + calls / 3;
}

Entry entry_of(const CalibratedRow& row) {
  const bool long_call = row.seconds > kLongCall;
  const std::int64_t calls = long_call ? 1 : calls_an_epoch(row.seconds);
  return {row.row->name,        Role::row, calls,     calls,     warm_up_of(row, calls), long_call,
          row.row->threads > 1, row.hash,  row.input, row.labels};
}

bool is_own_variant(const TimedRow& row) {
  return row.variant != nullptr && !row.variant->is_peer;
}

bool is_scalar(const TimedRow& row) {
  return row.variant->isa == Isa::baseline && !row.variant->technique.starts_with("simd") &&
         row.variant->technique != "autovec";
}

/// The fastest of the project's own rows on one thread that are wanted.
std::optional<std::size_t> fastest(const Rows& rows, const Wanted& is_wanted) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TimedRow& row = *rows[i].row;
    if (!is_own_variant(row) || row.threads > 1 || !is_wanted(row)) continue;
    if (!best || rows[i].seconds < rows[*best].seconds) best = i;
  }
  return best;
}

/// What the controls are made of: the fastest short row that is not the anchor. The anchor always
/// has other rows for neighbours; between two epochs of its own it would be up to 3 % faster.
std::size_t control_row(const Rows& rows, std::size_t anchor) {
  const std::string& taken = rows[anchor].row->name;
  const auto other = fastest(rows, [&](const TimedRow& row) { return row.name != taken; });
  return other && rows[*other].seconds <= kLongCall ? *other : anchor;
}

/// Pairs of all rows of a scope with the fastest of them that is wanted.
void pair_with_best(const Rows& rows, Scope scope, const std::string& against,
                    const Wanted& is_wanted, Group& group) {
  const auto best =
      fastest(rows, [&](const TimedRow& row) { return row.scope == scope && is_wanted(row); });
  for (std::size_t i = 1; best && i < rows.size(); ++i) {
    const TimedRow& row = *rows[i].row;
    if (i != *best && row.scope == scope && is_own_variant(row)) {
      group.pairs.push_back({i, *best, against});
    }
  }
}

void add_pairs(const Rows& rows, Group& group) {
  for (std::size_t i = 1; i < rows.size(); ++i) group.pairs.push_back({i, 0, "reference"});
  for (const Scope scope : {Scope::kernel, Scope::end_to_end}) {
    pair_with_best(rows, scope, "best_scalar", is_scalar, group);
    pair_with_best(
        rows, scope, "best_autovec",
        [](const TimedRow& row) { return row.variant->technique == "autovec"; }, group);
  }
}

void add_controls(std::size_t base, Group& group) {
  Entry same = group.entries[base];
  same.role = Role::same;
  Entry slowed = same;
  slowed.role = Role::slowed;
  slowed.counted = 10 * std::max<std::int64_t>(1, same.calls / 10);
  slowed.calls = slowed.counted / 10 * 11;
  for (Entry& control : {std::ref(same), std::ref(slowed)}) {
    group.pairs.push_back(
        {group.entries.size(), base, control.role == Role::same ? "same" : "slowed"});
    group.entries.push_back(std::move(control));
  }
}

/// An epoch, warm-up included.
double seconds_of(const Entry& entry, const Rows& rows) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const CalibratedRow& candidate) {
    return candidate.row->name == entry.name;
  });
  return static_cast<double>(entry.calls + entry.warm_up) * row->seconds;
}

/// Chooses sweeps and rounds such that all rounds take `budget` seconds.
void schedule(const Rows& rows, double budget, int most_rounds, Group& group) {
  const double anchor = seconds_of(group.entries[group.anchor], rows);
  double long_calls = 0;
  double sweep = 0;
  for (const Entry& entry : group.entries) {
    (entry.long_call ? long_calls : sweep) +=
        seconds_of(entry, rows) + (entry.long_call ? 0 : anchor);
  }
  sweep = std::max(sweep, anchor);
  const auto sweeps = static_cast<int>(std::min(long_calls / sweep, 1.0 * kMostSweeps));
  group.sweeps = std::max(kFewestSweeps, sweeps);
  const double round = long_calls + group.sweeps * sweep;
  const double affordable = std::min(budget / round, 1.0 * most_rounds);
  group.rounds = std::max(std::min(kFewestRounds, most_rounds), static_cast<int>(affordable));
  group.seconds = group.rounds * round;
}

}  // namespace

Group plan_group(const Rows& rows, const PlanLimits& limits) {
  Group group;
  for (const CalibratedRow& row : rows) group.entries.push_back(entry_of(row));
  add_pairs(rows, group);
  group.anchor = fastest(rows, [](const TimedRow&) { return true; }).value_or(0);
  add_controls(control_row(rows, group.anchor), group);
  const double budget = limits.seconds_per_pair * static_cast<double>(rows.size() - 1);
  schedule(rows, budget, limits.rounds, group);
  return group;
}

}  // namespace thinbench
