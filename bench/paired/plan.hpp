// What is measured and how often: made once, before the first process, and the same for all.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "timing/timed_row.hpp"

namespace thinbench {

/// Epochs of short calls last about as long (seconds); one call that takes longer than kLongCall is
/// an epoch of its own.
inline constexpr double kEpoch = 0.0003;
inline constexpr double kLongCall = 0.001;
/// Fewer rounds are not made, however slow the rows are.
inline constexpr int kFewestRounds = 3;
/// Short calls are visited more often in a round where long ones take most of its time.
inline constexpr int kFewestSweeps = 2;
inline constexpr int kMostSweeps = 12;

/// Names what a row works on.
struct InputFacts {
  std::string hash;
  std::int64_t pixels = 0;
};

/// A row with what has to be known of it to plan: its time was taken and its result hashed.
struct CalibratedRow {
  const TimedRow* row;
  double seconds;  // a call
  std::string hash;
  InputFacts input = {};
  CaseLabels labels = {};
};

enum class Role {
  row,
  same,    // control: a row again, to be found equal to itself
  slowed,  // control: a row with 11 calls for every 10 that are counted
};

/// Something that a round visits.
struct Entry {
  std::string name;  // case/technique/isa/threads/scope/input; entries may share it
  Role role = Role::row;
  std::int64_t calls = 1;    // an epoch
  std::int64_t counted = 1;  // by what its time is divided
  std::int64_t warm_up = 0;  // calls before each epoch that are not timed
  bool long_call = false;
  bool threaded = false;
  std::string hash;  // of the result
  InputFacts input = {};
  CaseLabels labels = {};
};

/// Two entries to be compared.
struct Pair {
  std::size_t row;
  std::size_t base;
  std::string against;  // "reference", "best_scalar", "best_autovec"; controls: "same", "slowed"
};

/// The rows of one case on one input, reference first, measured in common rounds.
struct Group {
  std::vector<Entry> entries;
  std::vector<Pair> pairs;
  std::size_t anchor = 0;  // the entry that all others are measured beside
  int rounds = 0;
  int sweeps = kFewestSweeps;  // over the short calls, in a round
  double seconds = 0;          // expected, for all rounds
};

struct PlanLimits {
  int rounds = 41;
  double seconds_per_pair = 0.02;  // in each process
};

/// Puts rows of one case and input, the reference first, into a plan. The anchor is
/// the fastest row on one thread, the controls are made of the next.
[[nodiscard]] Group plan_group(const std::vector<CalibratedRow>& rows, const PlanLimits& limits);

}  // namespace thinbench
