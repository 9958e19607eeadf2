#include "paired/statistics.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(Median, is_the_middle_value_or_the_mean_of_two) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
  EXPECT_THROW(static_cast<void>(median({})), std::invalid_argument);
}

TEST(IntervalRanks, of_nine_are_second_and_eighth) {
  const Ranks ranks = interval_ranks(9);
  EXPECT_EQ(ranks.low, 2U);
  EXPECT_EQ(ranks.high, 8U);
  EXPECT_DOUBLE_EQ(ranks.coverage, 1 - 20.0 / 512);
}

TEST(IntervalRanks, are_the_whole_range_where_values_are_few) {
  EXPECT_EQ(interval_ranks(1).high, 1U);
  EXPECT_DOUBLE_EQ(interval_ranks(1).coverage, 0);
  EXPECT_EQ(interval_ranks(3).low, 1U);
  EXPECT_EQ(interval_ranks(3).high, 3U);
  EXPECT_DOUBLE_EQ(interval_ranks(3).coverage, 0.75);
}

TEST(IntervalRanks, cover_95_percent_from_six_values_on_and_no_narrower_pair_does) {
  for (std::size_t n = 6; n < 60; ++n) {
    const Ranks ranks = interval_ranks(n);
    EXPECT_GE(ranks.coverage, 0.95) << n;
    EXPECT_LT(ranks.coverage, 0.995) << n;
    EXPECT_EQ(ranks.low + ranks.high, n + 1) << n;
  }
}

TEST(Estimate, of_logs_is_a_ratio_with_its_interval) {
  const Estimate estimate = estimate_of({0.9, 0.1, 0.3, 0.2, 0.5, 0.4, 0.6, 0.8, 0.7});
  EXPECT_DOUBLE_EQ(estimate.ratio, std::exp(0.5));
  EXPECT_DOUBLE_EQ(estimate.low, std::exp(0.2));
  EXPECT_DOUBLE_EQ(estimate.high, std::exp(0.8));
}

}  // namespace
}  // namespace thinbench
