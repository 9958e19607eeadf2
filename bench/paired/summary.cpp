#include "paired/summary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace thinbench {
namespace {

const ClockTimes& on_clock(const EntryTimes& times, bool wall) {
  return wall ? times.wall : times.thread_cpu;
}

bool is_slow_down_missed(const Estimate& slowed) {
  return std::log(slowed.ratio) > -kSlowedBeyond || slowed.high >= 1;
}

/// The controls of one role, over groups: a median for each process.
Estimate pooled(const std::vector<PairResult>& results, Role role) {
  std::vector<double> logs;
  for (std::size_t process = 0; process < results.front().processes; ++process) {
    std::vector<double> of_groups;
    for (const PairResult& result : results) {
      if (result.row->role == role) of_groups.push_back(result.estimate.logs[process]);
    }
    logs.push_back(median(std::move(of_groups)));
  }
  return estimate_of(std::move(logs));
}

std::vector<std::string> flags_of(const PairResult& result) {
  std::vector<std::string> flags;
  if (result.is_control()) {
    flags.emplace_back(result.failed() ? "control_failed" : "control_passed");
  }
  if (result.estimate.high / result.estimate.low > 1 + kNoisyWidth) flags.emplace_back("noisy");
  if (result.row->long_call || result.base->long_call) flags.emplace_back("long_call");
  if (result.rounds < kFewRounds) flags.emplace_back("few_rounds");
  return flags;
}

PairResult result_of(const Group& group, const Pair& pair,
                     const std::vector<const GroupTimes*>& processes) {
  const Entry& row = group.entries[pair.row];
  const Entry& base = group.entries[pair.base];
  const bool wall = row.threaded || base.threaded;
  std::vector<double> logs;
  std::vector<double> row_ns;
  std::vector<double> base_ns;
  for (const GroupTimes* times : processes) {
    const ClockTimes& of_row = on_clock(times->entries.at(pair.row), wall);
    const ClockTimes& of_base = on_clock(times->entries.at(pair.base), wall);
    logs.push_back(median(of_base.logs) - median(of_row.logs));
    row_ns.push_back(of_row.ns);
    base_ns.push_back(of_base.ns);
  }
  PairResult result{&row,
                    &base,
                    pair.against,
                    estimate_of(std::move(logs)),
                    median(std::move(row_ns)),
                    median(std::move(base_ns)),
                    (row.long_call || base.long_call ? 1 : group.sweeps) * group.rounds,
                    processes.size(),
                    processes.front()->layout,
                    {}};
  result.flags = flags_of(result);
  const bool direct = pair.row == group.anchor || pair.base == group.anchor;
  if (!direct) result.flags.emplace_back("via");
  return result;
}

void flag_all(std::vector<PairResult>& results, const std::string& flag) {
  for (PairResult& result : results) {
    const bool has = std::count(result.flags.begin(), result.flags.end(), flag) > 0;
    if (!has) result.flags.push_back(flag);
  }
}

}  // namespace

bool PairResult::failed() const {
  if (row->role == Role::slowed) return is_slow_down_missed(estimate);
  const bool is_off =
      std::log(estimate.low) > kSameWithin || std::log(estimate.high) < -kSameWithin;
  return row->role == Role::same && is_off;
}

bool Controls::pass() const {
  return std::abs(std::log(same.ratio)) <= kSameWithin && !is_slow_down_missed(slowed);
}

std::vector<PairResult> results_of(const std::vector<Group>& groups,
                                   const std::vector<std::vector<GroupTimes>>& processes) {
  std::vector<PairResult> results;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<const GroupTimes*> of_group;
    of_group.reserve(processes.size());
    for (const std::vector<GroupTimes>& process : processes) of_group.push_back(&process.at(i));
    std::vector<PairResult> of_pairs;
    for (const Pair& pair : groups[i].pairs) {
      of_pairs.push_back(result_of(groups[i], pair, of_group));
    }
    if (controls_of(of_pairs).failed_groups > 0) flag_all(of_pairs, "inconclusive");
    std::move(of_pairs.begin(), of_pairs.end(), std::back_inserter(results));
  }
  if (!controls_of(results).pass()) flag_all(results, "inconclusive");
  return results;
}

Controls controls_of(const std::vector<PairResult>& results) {
  Controls controls{pooled(results, Role::same), pooled(results, Role::slowed)};
  bool same_failed = false;
  for (const PairResult& result : results) {
    if (result.row->role == Role::same) same_failed = result.failed();
    if (result.row->role != Role::slowed) continue;  // the last of its group
    ++controls.groups;
    controls.failed_groups += same_failed || result.failed() ? 1 : 0;
  }
  return controls;
}

}  // namespace thinbench
