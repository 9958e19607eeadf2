// From the times of all processes to ratios, and what the controls say of them.
#pragma once

#include <string>
#include <vector>

#include "paired/statistics.hpp"
#include "paired/wire.hpp"

namespace thinbench {

/// How far from 1 a row may be from itself, and how far a row that is slowed by 10 % has to be from
/// itself: half of the 10 %.
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

  [[nodiscard]] bool is_control() const { return row->role != Role::kRow; }
  [[nodiscard]] bool failed() const;
  /// One clock for both sides: thread CPU time, which other processes hardly disturb, unless one
  /// side has threads.
  [[nodiscard]] std::string clock() const {
    return row->threaded || base->threaded ? "wall" : "thread_cpu";
  }
};

/// `processes[p]` holds what process p found, a group each, in the order of `groups`. Results point
/// to `groups`.
[[nodiscard]] std::vector<PairResult> results_of(
    const std::vector<Group>& groups, const std::vector<std::vector<GroupTimes>>& processes);

/// The controls among the results.
struct Controls {
  int passed = 0;
  int failed = 0;
};

[[nodiscard]] Controls controls_of(const std::vector<PairResult>& results);

}  // namespace thinbench
