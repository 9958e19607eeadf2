// Samples as thinbench_paired writes them, of a machine whose times are known.
#pragma once

#include <string>

#include "paired/output.hpp"
#include "paired/processes_for_tests.hpp"

namespace thinbench {

/// An operation whose reference takes 1 ms, `lut` 0.5 ms, and `simd_bytes` as long as is given.
inline std::string samples_for_tests(double simd_seconds, const MadeUp& made_up = {}) {
  RowsForTests rows(1e-3);
  rows.with("lut", 5e-4);
  rows.with("simd_bytes", simd_seconds, Isa::avx2);
  rows.with("simd_runs", 2e-5, Isa::avx2, 2);
  const std::vector<Group> groups = {plan_group(rows.rows(), {9, 1})};
  const auto processes = processes_of(groups[0], made_up, rows.rows());
  return to_json_lines(groups, processes, results_of(groups, processes));
}

}  // namespace thinbench
