#include "measure/rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

/// An anchor, two short entries and a long one.
Group group_for_tests() {
  Group group;
  group.entries.resize(4);
  group.entries[3].long_call = true;
  group.rounds = 3;
  group.sweeps = 2;
  return group;
}

/// The natural logarithm of the ratio to the anchor.
double log_ratio(const EntryTimes& times) {
  std::vector<int> logs = times.logs;
  std::nth_element(logs.begin(), logs.begin() + static_cast<std::ptrdiff_t>(logs.size() / 2),
                   logs.end());
  return logs[logs.size() / 2] / 1e4;
}

/// Nanoseconds of an epoch by entry.
constexpr std::array kTrue = {100.0, 200.0, 50.0, 1e4};

TEST(Rounds, short_entries_stand_between_two_epochs_of_the_anchor) {
  std::vector<std::size_t> order;
  static_cast<void>(measure_rounds(group_for_tests(), 1, [&](std::size_t entry) {
    order.push_back(entry);
    return Times{1, 1};
  }));
  EXPECT_EQ(order.size(), 3 * (2 * 5 + 1));
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != 1 && order[i] != 2) continue;
    EXPECT_EQ(order.at(i - 1), 0U);
    EXPECT_EQ(order.at(i + 1), 0U);
  }
  EXPECT_EQ(std::count(order.begin(), order.end(), 1), 6);
  EXPECT_EQ(std::count(order.begin(), order.end(), 3), 3);
}

TEST(Rounds, give_the_logarithm_of_the_ratio_to_the_anchor) {
  const auto times = measure_rounds(group_for_tests(), 1, [](std::size_t entry) {
    return Times{kTrue[entry], 3 * kTrue[entry]};
  });
  EXPECT_TRUE(times[0].logs.empty());
  for (std::size_t i = 0; i < kTrue.size(); ++i) {
    for (const double ns : times[i].ns) EXPECT_DOUBLE_EQ(ns, kTrue[i]);
    if (i == 0) continue;
    EXPECT_NEAR(log_ratio(times[i]), std::log(kTrue[i] / kTrue[0]), 1e-4) << i;
  }
  EXPECT_EQ(times[1].logs.size(), 6U);
  EXPECT_EQ(times[3].logs.size(), 3U);
}

TEST(Rounds, take_wall_time_for_entries_with_threads) {
  Group group = group_for_tests();
  group.entries[1].threaded = true;
  const auto times = measure_rounds(group, 1, [](std::size_t entry) {
    return Times{1, 3 * kTrue[entry]};
  });
  EXPECT_DOUBLE_EQ(times[1].ns[0], 600);
  EXPECT_NEAR(log_ratio(times[1]), std::log(2), 1e-4);
}

TEST(Rounds, divide_by_the_calls_that_count) {
  Group group = group_for_tests();
  group.entries[1].counted = 10;
  const auto times = measure_rounds(group, 1, [](std::size_t) { return Times{100, 100}; });
  EXPECT_DOUBLE_EQ(times[1].ns[0], 10);
  EXPECT_NEAR(log_ratio(times[1]), std::log(0.1), 1e-4);
}

TEST(Rounds, a_machine_that_slows_down_steadily_leaves_ratios_of_short_entries_as_they_are) {
  double slowness = 1;
  const auto times = measure_rounds(group_for_tests(), 1, [&](std::size_t entry) {
    slowness *= 1.01;
    return Times{slowness * kTrue[entry], slowness * kTrue[entry]};
  });
  EXPECT_NEAR(log_ratio(times[1]), std::log(2), 1e-4);
  EXPECT_NEAR(log_ratio(times[2]), std::log(0.5), 1e-4);
}

TEST(Rounds, one_interruption_moves_no_ratio) {
  int visits = 0;
  const auto times = measure_rounds(group_for_tests(), 1, [&](std::size_t entry) {
    const double stolen = ++visits == 8 ? 1e9 : 0;
    return Times{kTrue[entry] + stolen, kTrue[entry] + stolen};
  });
  for (std::size_t i = 1; i < kTrue.size(); ++i) {
    EXPECT_NEAR(log_ratio(times[i]), std::log(kTrue[i] / kTrue[0]), 1e-4) << i;
  }
}

TEST(Shuffled, is_a_permutation_that_depends_on_the_seed) {
  EXPECT_EQ(shuffled(20, 7), shuffled(20, 7));
  EXPECT_NE(shuffled(20, 7), shuffled(20, 8));
  std::vector<std::size_t> order = shuffled(20, 7);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  EXPECT_TRUE(shuffled(0, 7).empty());
}

}  // namespace
}  // namespace thinbench
