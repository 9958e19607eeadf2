#include "regress/controls.hpp"

#include <gtest/gtest.h>

#include "regress/compare.hpp"
#include "regress/made_up_runs.hpp"

namespace thinbench {
namespace {

void shift(std::vector<double>& logs, double by) {
  for (double& log : logs) log += by;
}

TEST(GateControls, pass_on_a_machine_of_usual_noise_within_and_between_processes) {
  for (const Neighbour neighbour : {Neighbour::same_process, Neighbour::next_process}) {
    const ControlVerdicts verdicts = judge_controls(run_for_tests(1), neighbour);
    EXPECT_TRUE(verdicts.pass);
    EXPECT_TRUE(verdicts.failed_groups.empty());
    EXPECT_NEAR(verdicts.slowed.ratio, 1 / 1.1, 0.02);
  }
}

TEST(GateControls, row_that_differs_from_itself_puts_all_rows_in_doubt) {
  MeasuredRun run = run_for_tests(1, 0.5);
  shift(run.controls["copy/scene"].same, 0.03);
  const ControlVerdicts verdicts = judge_controls(run, Neighbour::same_process);
  EXPECT_FALSE(verdicts.pass);
  std::vector<RegressionVerdict> rows = between(run_for_tests(2), run, {false, 2048});
  doubt(verdicts, rows);
  for (const RegressionVerdict& row : rows) EXPECT_EQ(row.verdict, Verdict::undecided) << row.name;
  EXPECT_EQ(rows.front().reason, "a control failed");
}

TEST(GateControls, planted_slow_down_that_is_missed_fails) {
  MeasuredRun run = run_for_tests(1);
  shift(run.controls["copy/scene"].slowed, 0.09);
  const ControlVerdicts verdicts = judge_controls(run, Neighbour::same_process);
  EXPECT_FALSE(verdicts.pass);
  EXPECT_EQ(verdicts.failed_groups, (std::set<std::string>{"copy/scene"}));
}

TEST(GateControls, run_without_controls_is_refused) {
  MeasuredRun run = run_for_tests(1);
  run.controls["copy/scene"].same.pop_back();
  EXPECT_THROW(static_cast<void>(judge_controls(run, Neighbour::same_process)), std::runtime_error);
  run.controls.clear();
  EXPECT_THROW(static_cast<void>(judge_controls(run, Neighbour::same_process)), std::runtime_error);
}

}  // namespace
}  // namespace thinbench
