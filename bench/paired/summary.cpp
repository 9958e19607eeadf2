#include "paired/summary.hpp"

#include <algorithm>
#include <cmath>

namespace thinbench {
namespace {

const std::vector<double>& times_of(const EntryTimes& times, bool wall) {
  return wall ? times.wall : times.thread_cpu;
}

/// The median over rounds of ln(base time / row time).
double log_ratio(const std::vector<double>& row, const std::vector<double>& base) {
  std::vector<double> logs;
  for (std::size_t round = 0; round < row.size(); ++round) {
    logs.push_back(std::log(base.at(round) / row[round]));
  }
  return median(std::move(logs));
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
    const std::vector<double>& of_row = times_of(times->entries.at(pair.row), wall);
    const std::vector<double>& of_base = times_of(times->entries.at(pair.base), wall);
    logs.push_back(log_ratio(of_row, of_base));
    row_ns.push_back(median(of_row));
    base_ns.push_back(median(of_base));
  }
  PairResult result{&row,
                    &base,
                    pair.against,
                    estimate_of(std::move(logs)),
                    median(std::move(row_ns)),
                    median(std::move(base_ns)),
                    group.rounds,
                    processes.size(),
                    processes.front()->layout,
                    {}};
  result.flags = flags_of(result);
  return result;
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
    for (const Pair& pair : groups[i].pairs) {
      results.push_back(result_of(groups[i], pair, of_group));
    }
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
