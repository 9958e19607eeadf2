#include "regress/verdict.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

constexpr auto kPass = Verdict::pass;
constexpr auto kFail = Verdict::fail;
constexpr auto kUndecided = Verdict::undecided;
constexpr auto kSkipped = Verdict::skipped;

TEST(Verdict, fails_only_where_the_whole_interval_is_below_the_limit) {
  EXPECT_EQ(judge({0.93, 0.92, 0.9499}, kOneJobTolerance), kFail);
  EXPECT_EQ(judge({0.93, 0.92, 0.95}, kOneJobTolerance), kUndecided);
  EXPECT_EQ(judge({0.97, 0.95, 0.99}, kOneJobTolerance), kPass);
  EXPECT_EQ(judge({0.93, 0.92, 0.9499}, kStoredTolerance), kPass);
}

TEST(Verdict, interval_that_does_not_exclude_a_slow_down_is_not_green) {
  EXPECT_EQ(judge({1.00, 0.94, 1.05}, kOneJobTolerance), kUndecided);
}

TEST(Verdict, failure_needs_two_runs) {
  EXPECT_EQ(confirmed(kFail, kFail), kFail);
  EXPECT_EQ(confirmed(kFail, kPass), kUndecided);
  EXPECT_EQ(confirmed(kFail, kUndecided), kUndecided);
  EXPECT_EQ(confirmed(kUndecided, kFail), kUndecided);
}

TEST(Verdict, second_look_settles_what_was_too_noisy) {
  EXPECT_EQ(confirmed(kUndecided, kPass), kPass);
  EXPECT_EQ(confirmed(kPass, kUndecided), kPass);
  EXPECT_EQ(confirmed(kUndecided, kUndecided), kUndecided);
}

TEST(Verdict, run_is_as_bad_as_its_worst_row) {
  EXPECT_EQ(overall({kPass, kFail, kUndecided, kSkipped}), kFail);
  EXPECT_EQ(overall({kPass, kUndecided, kSkipped}), kUndecided);
  EXPECT_EQ(overall({kPass, kSkipped}), kPass);
}

TEST(Verdict, nothing_compared_is_never_green) {
  EXPECT_EQ(exit_status(overall({})), 4);
  EXPECT_EQ(exit_status(overall({kSkipped, kSkipped})), 4);
  EXPECT_EQ(exit_status(kPass), 0);
  EXPECT_EQ(exit_status(kFail), 1);
  EXPECT_EQ(exit_status(kUndecided), 3);
}

TEST(Verdict, pictures_beyond_the_cache_may_vary_more) {
  EXPECT_EQ(tolerance_of(kStoredTolerance, 510 * 412, 2048), kStoredTolerance);
  EXPECT_EQ(tolerance_of(kStoredTolerance, 1024 * 1024, 2048), kStoredTolerance);
  EXPECT_EQ(tolerance_of(kStoredTolerance, 1024 * 1024 + 1, 2048), kBeyondCacheTolerance);
  EXPECT_EQ(tolerance_of(kOneJobTolerance, 4096 * 4096, 2048), kBeyondCacheTolerance);
}

}  // namespace
}  // namespace thinbench
