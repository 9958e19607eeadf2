// Does this run tell a row from itself, and does it see a slow-down that was planted?
#pragma once

#include <set>
#include <string>

#include "regress/run.hpp"
#include "regress/verdict.hpp"

namespace thinbench {

/// Whether a control is compared with its row in the same process, as runs against a stored
/// baseline are judged, or in the next one, as two builds are.
enum class Neighbour { same_process, next_process };

struct ControlVerdicts {
  Change same;  // over all groups: a process gives the median of its groups
  Change slowed;
  std::set<std::string> failed_groups;
  bool pass = false;  // for the run as a whole
};

/// A row against itself has to come within 1 % of 1; one slowed by 10 % has to be beyond the 5 %
/// allowed between two builds, with an interval that excludes 1. Throws std::runtime_error where
/// controls are missing.
[[nodiscard]] ControlVerdicts judge_controls(const MeasuredRun& run, Neighbour neighbour);

}  // namespace thinbench
