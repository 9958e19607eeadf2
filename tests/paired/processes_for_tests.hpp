// Measurements that were made up: what a machine of known speed and noise would have answered.
#pragma once

#include <cmath>
#include <vector>

#include "paired/rows_for_tests.hpp"
#include "paired/summary.hpp"

namespace thinbench {

struct MadeUp {
  double same_log = 0;        // what the control finds of a row against itself
  double slowed_log = 0.095;  // and how much slower the slowed one
  double spread = 0.001;      // between processes
};

/// Nine processes over one group. Every row takes the seconds it was planned with.
inline std::vector<std::vector<GroupTimes>> processes_of(const Group& group, const MadeUp& made_up,
                                                         const std::vector<CalibratedRow>& rows) {
  const auto seconds_of = [&](const Entry& entry) {
    double seconds = 0;
    for (const CalibratedRow& row : rows) {
      if (row.row->name == entry.name) seconds = row.seconds;
    }
    return seconds;
  };
  std::vector<std::vector<GroupTimes>> processes;
  for (int process = -4; process <= 4; ++process) {
    GroupTimes times{0, {}, {0, 2048}};
    for (std::size_t i = 0; i < group.entries.size(); ++i) {
      const Entry& entry = group.entries[i];
      double log = std::log(seconds_of(entry) / seconds_of(group.entries[group.anchor]));
      if (entry.role == Role::same) log += made_up.same_log;
      if (entry.role == Role::slowed) log += made_up.slowed_log;
      log += process * made_up.spread * static_cast<double>(i);
      const ClockTimes clock{{log, log, log}, 1e9 * seconds_of(entry)};
      times.entries.push_back({clock, clock});
    }
    processes.push_back({times});
  }
  return processes;
}

}  // namespace thinbench
