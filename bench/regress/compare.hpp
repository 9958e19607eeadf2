// A verdict for every row: against a baseline, between two builds, and of SIMD against scalar code.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "regress/baseline.hpp"
#include "regress/controls.hpp"
#include "regress/run.hpp"
#include "regress/verdict.hpp"

namespace thinbench {

struct RegressionVerdict {
  std::string name;  // case/technique/isa/threads/scope/input
  Verdict verdict = Verdict::skipped;
  std::string reason;  // where it is not plainly what the interval says
  double tolerance = 0;
  Change change;
  PairTimes before;
  PairTimes now;
};

struct Rules {
  /// Rows with threads depend on what else the cores do, so that they are not judged otherwise.
  bool judge_threads = false;
  std::int64_t cache_kib = 0;  // of one core alone
};

/// Every row of either. A row that seems slower, but was measured beside other rows than in the
/// baseline, is inconclusive: neighbours alone can change a time by more than the tolerance.
[[nodiscard]] std::vector<RegressionVerdict> against_baseline(const MeasuredRun& run,
                                                              const Baseline& baseline,
                                                              const Rules& rules);

/// Process by process, as both were measured interleaved.
[[nodiscard]] std::vector<RegressionVerdict> between(const MeasuredRun& before,
                                                     const MeasuredRun& now, const Rules& rules);

/// Every SIMD row on one thread against the scalar row of the same kind and scope where there is
/// one, else against the reference.
[[nodiscard]] std::vector<RegressionVerdict> against_scalar(const MeasuredRun& run);

/// Rows that were measured while a control failed are inconclusive.
void doubt(const ControlVerdicts& controls, std::vector<RegressionVerdict>& rows);

/// Takes the rows that were measured again for confirmed or not.
void confirm(const std::vector<RegressionVerdict>& again, std::vector<RegressionVerdict>& rows);

}  // namespace thinbench
