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

bool control_failed(const PairResult& result) {
  const Estimate& estimate = result.estimate;
  if (result.row->role == Role::kSame) return std::abs(std::log(estimate.ratio)) > kSameWithin;
  return std::log(estimate.ratio) > -kSlowedBeyond || estimate.high >= 1;
}

std::vector<std::string> flags_of(const PairResult& result) {
  std::vector<std::string> flags;
  if (result.is_control()) {
    flags.emplace_back(control_failed(result) ? "control_failed" : "control_passed");
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
  for (PairResult& result : results) result.flags.push_back(flag);
}

}  // namespace

bool PairResult::failed() const {
  return is_control() && control_failed(*this);
}

std::vector<PairResult> results_of(const std::vector<Group>& groups,
                                   const std::vector<std::vector<GroupTimes>>& processes) {
  std::vector<PairResult> results;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    std::vector<const GroupTimes*> of_group;
    for (const std::vector<GroupTimes>& process : processes) of_group.push_back(&process.at(i));
    std::vector<PairResult> of_pairs;
    for (const Pair& pair : groups[i].pairs) {
      of_pairs.push_back(result_of(groups[i], pair, of_group));
    }
    if (controls_of(of_pairs).failed > 0) flag_all(of_pairs, "inconclusive");
    std::move(of_pairs.begin(), of_pairs.end(), std::back_inserter(results));
  }
  return results;
}

Controls controls_of(const std::vector<PairResult>& results) {
  Controls controls;
  for (const PairResult& result : results) {
    if (result.is_control()) ++(result.failed() ? controls.failed : controls.passed);
  }
  return controls;
}

}  // namespace thinbench
