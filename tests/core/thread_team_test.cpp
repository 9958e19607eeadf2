#include "core/thread_team.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

TEST(ThreadTeam, ranges_cover_every_index_once) {
  for (const int threads : {1, 2, 7}) {
    ThreadTeam team(threads);
    for (const Index count : {0, 1, 2, 6, 7, 8, 1000}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
      team.for_ranges(count, [&](Index first, Index last) {
        for (Index i = first; i < last; ++i) ++visits[static_cast<std::size_t>(i)];
      });
      for (const auto& visit : visits) EXPECT_EQ(visit, 1);
    }
  }
}

TEST(ThreadTeam, makes_no_more_ranges_than_threads) {
  ThreadTeam team(7);
  std::atomic<int> ranges = 0;
  team.for_ranges(1000, [&](Index, Index) { ++ranges; });
  EXPECT_EQ(ranges, 7);
}

TEST(ThreadTeam, many_short_loops_of_an_awake_team_cover_every_index_once) {
  constexpr int loops = 3000;
  for (const int threads : {1, 2, 5}) {
    const ThreadTeam team(threads);
    std::vector<int> visits(37);
    team.stay_awake([&] {
      for (int loop = 0; loop < loops; ++loop) {
        team.for_ranges(1 + loop % 37, [&](Index first, Index last) {
          for (Index i = first; i < last; ++i) ++visits[static_cast<std::size_t>(i)];
        });
      }
    });
    for (int i = 0; i < 37; ++i) {
      int expected = 0;
      for (int loop = 0; loop < loops; ++loop) expected += i < 1 + loop % 37 ? 1 : 0;
      EXPECT_EQ(visits[static_cast<std::size_t>(i)], expected)
          << threads << " threads, index " << i;
    }
  }
}

TEST(ThreadTeam, what_one_awake_loop_wrote_the_next_one_sees) {
  const ThreadTeam team(2);
  std::vector<int> numbers(64, 0);
  team.stay_awake([&] {
    for (int step = 0; step < 500; ++step) {
      const std::vector<int> before = numbers;
      team.for_ranges(64, [&](Index first, Index last) {
        for (Index i = first; i < last; ++i) {
          numbers[static_cast<std::size_t>(i)] = before[static_cast<std::size_t>(63 - i)] + 1;
        }
      });
    }
  });
  EXPECT_EQ(numbers, std::vector<int>(64, 500));
}

TEST(ThreadTeam, falls_asleep_again_where_the_body_throws) {
  const ThreadTeam team(2);
  EXPECT_THROW(team.stay_awake([] { throw std::runtime_error("stop"); }), std::runtime_error);
  int calls = 0;
  team.stay_awake([&] { team.stay_awake([&] { ++calls; }); });
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace thinbench
