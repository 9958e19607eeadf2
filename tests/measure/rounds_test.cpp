#include "measure/rounds.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

/// Nanoseconds of an epoch by entry.
constexpr std::array kTrue = {100.0, 200.0, 50.0, 1e4};

/// The last entry is visited once in a layout.
std::vector<Entry> entries_for_tests() {
  std::vector<Entry> entries(kTrue.size());
  for (Entry& entry : entries) entry.visits = 6;
  entries.back().visits = 1;
  return entries;
}

TEST(Rounds, visit_each_entry_as_often_as_it_says_and_none_twice_in_a_round) {
  std::vector<std::size_t> order;
  const auto times = measure_rounds(entries_for_tests(), 1, [&](std::size_t entry) {
    order.push_back(entry);
    return kTrue[entry];
  });
  ASSERT_EQ(order.size(), 3U * 6 + 1);
  for (std::size_t i = 4; i + 3 <= order.size(); i += 3) {
    std::vector<std::size_t> round(order.begin() + static_cast<std::ptrdiff_t>(i),
                                   order.begin() + static_cast<std::ptrdiff_t>(i + 3));
    std::sort(round.begin(), round.end());
    EXPECT_EQ(round, (std::vector<std::size_t>{0, 1, 2}));
  }
  EXPECT_EQ(times[0], EntryTimes(6, kTrue[0]));
  EXPECT_EQ(times[3], EntryTimes(1, kTrue[3]));
}

TEST(Rounds, divide_by_the_calls_and_round_to_five_digits) {
  std::vector<Entry> entries = entries_for_tests();
  entries[1].calls = 3;
  const auto times = measure_rounds(entries, 1, [](std::size_t) { return 1e6; });
  EXPECT_DOUBLE_EQ(times[1][0], 333330);
  entries[1].calls = 3'000'000;
  EXPECT_DOUBLE_EQ(measure_rounds(entries, 1, [](std::size_t) { return 1e6; })[1][0], 0.33333);
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
