#include "timing/schedule.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(Schedule, fast_rows_fill_a_repetition_and_are_warmed_up) {
  const Schedule schedule = schedule_of(0.001, 15, 0.01);
  EXPECT_EQ(schedule.iterations, 10);
  EXPECT_EQ(schedule.repetitions, 15);
  EXPECT_TRUE(schedule.warm_up);
  EXPECT_NEAR(schedule.seconds_a_repetition, 0.011, 1e-9);
}

TEST(Schedule, slow_rows_run_a_third_of_the_repetitions_cold) {
  const Schedule schedule = schedule_of(2, 15, 0.01);
  EXPECT_EQ(schedule.iterations, 1);
  EXPECT_EQ(schedule.repetitions, 5);
  EXPECT_FALSE(schedule.warm_up);
  EXPECT_NEAR(schedule.seconds_a_repetition, 2, 1e-9);
  EXPECT_EQ(schedule_of(2, 7, 0.01).repetitions, 3);
}

TEST(Schedule, no_row_runs_more_often_than_asked_for) {
  for (const int repetitions : {1, 2, 3}) {
    EXPECT_EQ(schedule_of(2, repetitions, 0.01).repetitions, repetitions);
    EXPECT_FALSE(schedule_of(2, repetitions, 0.01).warm_up);
  }
}

}  // namespace
}  // namespace thinbench
