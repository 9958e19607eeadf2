// One repetition of a benchmark: a new job, warmed up, and timed between two probes.
#pragma once

#include <map>
#include <memory>

#include <benchmark/benchmark.h>

#include "measure/known_rows.hpp"
#include "measure/workspace.hpp"

namespace thinbench {

/// Names of the counters of each repetition, in ns.
inline constexpr const char* kProbeBefore = "probe_before";
inline constexpr const char* kProbeAfter = "probe_after";
inline constexpr const char* kCycle = "cycle";

/// What one benchmark measures.
struct Measured {
  KnownRow known;
  std::int64_t calls = 1;    // in a repetition
  std::int64_t warm_up = 0;  // untimed calls before
  int repetitions = 1;
  double delay_ns = 0;      // injected, for each call
  bool is_checked = false;  // the result is the verified one

  /// A repetition takes about 0.3 ms or one call, all of them about `seconds`.
  Measured(const KnownRow& row, double seconds, int min_repetitions);
};

/// Source and destination of inputs, each made once, as they lie at the same place of a page in
/// every process.
class Workspaces {
 public:
  Workspace& of(const ConstImageView& input);

 private:
  std::map<const std::uint8_t*, std::unique_ptr<Workspace>> workspaces_;
};

/// Carries out a repetition. A failing call or, in the first repetition, another result than the
/// verified one is an error of the benchmark.
void repeat(benchmark::State& state, Measured& measured, Workspaces& workspaces);

}  // namespace thinbench
