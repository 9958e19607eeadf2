// From the times of all processes to ratios, and what the controls say of them.
#pragma once

#include <string>
#include <vector>

#include "paired/statistics.hpp"
#include "paired/wire.hpp"

namespace thinbench {

/// How far from 1 a row may be from itself (logarithms), and how far a row slowed by 10 % has to be
/// from itself: half of the 10 %.
inline constexpr double kSameWithin = 0.01;
inline constexpr double kSlowedBeyond = 0.05;
/// An interval wider than this is called noisy.
inline constexpr double kNoisyWidth = 0.10;
/// Medians over fewer rounds are flagged.
inline constexpr int kFewRounds = 5;

/// A pair with what all processes together say of it.
struct PairResult {
  const Entry* row;
  const Entry* base;
  std::string against;
  Estimate estimate;  // base time / row time
  double row_ns;      // median over processes of medians over visits
  double base_ns;
  int rounds;  // visits in a process of the side that was visited less often
  std::size_t processes;
  std::vector<std::size_t> layout;
  std::vector<std::string> flags;

  [[nodiscard]] bool is_control() const { return row->role != Role::row; }
  /// For a control: its interval does not come within 1 % of 1, or does not exclude 1 where the row
  /// was slowed.
  [[nodiscard]] bool failed() const;
  /// One clock for both sides: thread CPU time, which other processes hardly disturb, unless one
  /// side has threads.
  [[nodiscard]] std::string clock() const {
    return row->threaded || base->threaded ? "wall" : "thread_cpu";
  }
};

/// Rows of a group with a failed control are flagged `inconclusive`, all rows where the controls of
/// the run do not pass.
/// `processes[p]` holds what process p found, a group each, in the order of `groups`. Results point
/// to `groups`.
[[nodiscard]] std::vector<PairResult> results_of(
    const std::vector<Group>& groups, const std::vector<std::vector<GroupTimes>>& processes);

/// What the controls of all groups together say of a run; each process gives the median over
/// groups.
struct Controls {
  Estimate same;
  Estimate slowed;
  int groups = 0;
  int failed_groups = 0;  // whose rows are flagged

  /// A row is itself within 1 %, and a slow-down by 10 % is seen: else nothing is concluded.
  [[nodiscard]] bool pass() const;
};

[[nodiscard]] Controls controls_of(const std::vector<PairResult>& results);

}  // namespace thinbench
