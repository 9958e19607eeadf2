#include "image/thread_team.hpp"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace thinbench::detail {
namespace {

TEST(ThreadTeam, ranges_cover_every_index_exactly_once) {
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

TEST(ThreadTeam, makes_one_range_per_thread) {
  ThreadTeam team(7);
  std::atomic<int> ranges = 0;
  team.for_ranges(1000, [&](Index, Index) { ++ranges; });
  EXPECT_EQ(ranges, 7);
}

}  // namespace
}  // namespace thinbench::detail
