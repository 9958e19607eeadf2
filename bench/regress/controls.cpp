#include "regress/controls.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "paired/statistics.hpp"
#include "paired/summary.hpp"

namespace thinbench {
namespace {

using Logs = std::vector<double>;

Change change_of(const Logs& logs) {
  const Estimate estimate = estimate_of(logs);
  return {estimate.ratio, estimate.low, estimate.high};
}

/// The control in each process, divided by its row there or in the process before.
Logs against_row(const MeasuredRun& run, const MeasuredControls& controls, const Logs& control,
                 Neighbour neighbour) {
  const std::size_t shift = neighbour == Neighbour::next_process ? 1 : 0;
  Logs logs;
  for (std::size_t i = 0; i < control.size(); ++i) {
    const std::size_t of_control = (i + shift) % control.size();
    const Logs& row = run.rows.at(controls.base[of_control]).logs;
    logs.push_back(control[of_control] - row.at(i));
  }
  return logs;
}

Change pooled(const std::vector<Logs>& groups) {
  Logs logs;
  for (std::size_t process = 0; process < groups.front().size(); ++process) {
    Logs of_groups;
    for (const Logs& group : groups) of_groups.push_back(group.at(process));
    logs.push_back(median(of_groups));
  }
  return change_of(logs);
}

bool is_off(const Change& same) {
  return std::log(same.low) > kSameWithin || std::log(same.high) < -kSameWithin;
}

/// Nearer to a row's own speed than to one that would be FAIL, or not told from it.
bool is_missed(const Change& slowed) {
  return slowed.ratio > 1 - kOneJobTolerance || slowed.high >= 1;
}

}  // namespace

ControlVerdicts judge_controls(const MeasuredRun& run, Neighbour neighbour) {
  std::vector<Logs> same;
  std::vector<Logs> slowed;
  ControlVerdicts verdicts;
  for (const auto& [group, controls] : run.controls) {
    if (controls.same.size() != run.processes || controls.slowed.size() != run.processes) {
      throw std::runtime_error("controls of " + group + " are missing in some processes");
    }
    same.push_back(against_row(run, controls, controls.same, neighbour));
    slowed.push_back(against_row(run, controls, controls.slowed, neighbour));
    if (is_missed(change_of(slowed.back())) || is_off(change_of(same.back()))) {
      verdicts.failed_groups.insert(group);
    }
  }
  if (same.empty()) throw std::runtime_error("there are no controls");
  verdicts.same = pooled(same);
  verdicts.slowed = pooled(slowed);
  verdicts.pass = !is_missed(verdicts.slowed) && !is_off(verdicts.same);
  return verdicts;
}

}  // namespace thinbench
