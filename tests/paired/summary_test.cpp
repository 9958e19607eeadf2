#include "paired/summary.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "paired/processes_for_tests.hpp"

namespace thinbench {
namespace {

class Summary : public testing::Test {
 protected:
  Summary() : rows(1e-3) {
    rows.with("lut", 5e-4);
    rows.with("simd_bytes", 1e-5, Isa::avx2);
    rows.with("simd_runs", 2e-5, Isa::avx2, 2);
    groups = {plan_group(rows.rows(), {9, 1})};
  }

  std::vector<PairResult> results(const MadeUp& made_up) {
    return results_of(groups, processes_of(groups[0], made_up, rows.rows()));
  }

  static bool has(const PairResult& result, const std::string& flag) {
    return std::count(result.flags.begin(), result.flags.end(), flag) > 0;
  }

  RowsForTests rows;
  std::vector<Group> groups;
};

TEST_F(Summary, ratio_is_the_reference_s_time_over_the_row_s) {
  const std::vector<PairResult> found = results({});
  EXPECT_EQ(found[0].against, "reference");
  EXPECT_NEAR(found[0].estimate.ratio, 2, 1e-9);
  EXPECT_NEAR(found[0].estimate.low, 2 * std::exp(-0.003), 1e-9);
  EXPECT_NEAR(found[0].estimate.high, 2 * std::exp(0.003), 1e-9);
  EXPECT_NEAR(found[0].base_ns, 1e6, 1e-3);
  EXPECT_NEAR(found[0].row_ns, 5e5, 1e-3);
  EXPECT_EQ(found[0].processes, 9U);
}

TEST_F(Summary, rows_with_threads_are_measured_on_the_wall_clock) {
  const std::vector<PairResult> found = results({});
  EXPECT_EQ(found[0].clock(), "thread_cpu");
  EXPECT_EQ(found[2].clock(), "wall");
}

TEST_F(Summary, controls_pass_on_a_machine_that_is_quiet) {
  const Controls controls = controls_of(results({}));
  EXPECT_TRUE(controls.pass());
  EXPECT_EQ(controls.groups, 1);
  EXPECT_EQ(controls.failed_groups, 0);
  EXPECT_NEAR(controls.same.ratio, 1, 1e-9);
  EXPECT_NEAR(controls.slowed.ratio, std::exp(-0.095), 1e-9);
}

TEST_F(Summary, row_that_differs_from_itself_makes_its_group_inconclusive) {
  for (const double log : {0.02, -0.02}) {
    const std::vector<PairResult> found = results({log});
    EXPECT_FALSE(controls_of(found).pass());
    EXPECT_EQ(controls_of(found).failed_groups, 1);
    for (const PairResult& result : found) EXPECT_TRUE(has(result, "inconclusive"));
  }
  EXPECT_TRUE(controls_of(results({0.009})).pass());
}

TEST_F(Summary, slow_down_that_is_missed_is_a_failed_control) {
  EXPECT_FALSE(controls_of(results({0, 0.0})).pass());
  EXPECT_FALSE(controls_of(results({0, 0.04})).pass());
  EXPECT_FALSE(controls_of(results({0, 0.095, 0.1})).pass());
  EXPECT_EQ(controls_of(results({0, 0.0})).failed_groups, 1);
}

TEST_F(Summary, one_group_with_a_failed_control_flags_its_rows_and_leaves_the_run) {
  groups = {groups[0], groups[0], groups[0]};
  auto processes = processes_of(groups[0], {}, rows.rows());
  const auto off = processes_of(groups[0], {0.05}, rows.rows());
  for (std::size_t p = 0; p < processes.size(); ++p) {
    processes[p] = {processes[p][0], off[p][0], processes[p][0]};
  }
  const std::vector<PairResult> found = results_of(groups, processes);
  EXPECT_TRUE(controls_of(found).pass());
  EXPECT_EQ(controls_of(found).failed_groups, 1);
  const std::size_t pairs = groups[0].pairs.size();
  EXPECT_FALSE(has(found[0], "inconclusive"));
  EXPECT_TRUE(has(found[pairs], "inconclusive"));
}

TEST_F(Summary, run_whose_controls_fail_together_flags_all_rows) {
  groups = {groups[0], groups[0], groups[0]};
  const auto good = processes_of(groups[0], {}, rows.rows());
  auto processes = processes_of(groups[0], {0.05}, rows.rows());
  for (std::size_t p = 0; p < processes.size(); ++p) {
    processes[p] = {processes[p][0], good[p][0], processes[p][0]};
  }
  for (const PairResult& result : results_of(groups, processes)) {
    EXPECT_EQ(std::count(result.flags.begin(), result.flags.end(), "inconclusive"), 1);
  }
}

TEST_F(Summary, wide_intervals_are_noisy) {
  EXPECT_FALSE(has(results({})[0], "noisy"));
  EXPECT_TRUE(has(results({0, 0.095, 0.02})[0], "noisy"));
}

TEST_F(Summary, few_rounds_and_long_calls_are_flagged) {
  EXPECT_FALSE(has(results({})[0], "few_rounds"));
  RowsForTests slow(1e-2);
  slow.with("lut", 5e-4);
  groups = {plan_group(slow.rows(), {41, 0})};
  const PairResult result = results_of(groups, processes_of(groups[0], {}, slow.rows())).front();
  EXPECT_TRUE(has(result, "few_rounds"));
  EXPECT_TRUE(has(result, "long_call"));
  EXPECT_EQ(result.rounds, 3);
}

}  // namespace
}  // namespace thinbench
