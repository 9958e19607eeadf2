// Verdicts as text.
#pragma once

#include <string>
#include <vector>

#include "regress/compare.hpp"

namespace thinbench {

/// What changed by more than 3 %, the row or its reference: a speed-up also falls when the
/// reference gets faster.
[[nodiscard]] std::string what_moved(const PairTimes& before, const PairTimes& now);

/// Rows that are not PASS, and those that got faster by more than the tolerance, with times of both
/// sides; reasons of skipped rows with their number. With `all`, every row.
[[nodiscard]] std::string to_table(const std::vector<RegressionVerdict>& rows, bool all);

/// SIMD rows that are not PASS, with times of both sides; with `all`, every one.
[[nodiscard]] std::string to_simd_table(const std::vector<RegressionVerdict>& rows, bool all);

/// How many rows have which verdict: "PASS 90, FAIL 1".
[[nodiscard]] std::string counts(const std::vector<RegressionVerdict>& rows);

[[nodiscard]] std::string to_line(const ControlVerdicts& controls);

}  // namespace thinbench
