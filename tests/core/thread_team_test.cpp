#include "core/thread_team.hpp"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#include <unistd.h>
#endif
#ifdef THINBENCH_WITH_TBB
#include <tbb/global_control.h>
#endif

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

#if __has_include(<sys/resource.h>)
/// The address space that this process uses.
std::size_t used_bytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Leaves with 0 if all indices were visited where there is memory for the stacks of few threads.
void run_with_little_memory(int threads) {
  rlimit little{};
  getrlimit(RLIMIT_AS, &little);
  little.rlim_cur = used_bytes() + (std::size_t{16} << 20);
  if (setrlimit(RLIMIT_AS, &little) != 0) std::_Exit(2);
  std::atomic<Index> visits = 0;
  for (int i = 0; i < 100; ++i) {
    ThreadTeam(threads).for_ranges(1000, [&](Index first, Index last) { visits += last - first; });
  }
  std::_Exit(visits == 100'000 ? 0 : 1);
}

TEST(ThreadTeam, runs_with_fewer_threads_where_the_system_does_not_start_more) {
#ifdef THINBENCH_SANITIZED
  GTEST_SKIP() << "sanitizers need address space without a limit";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(run_with_little_memory(8), testing::ExitedWithCode(0), "^$");
}
#endif

#ifdef THINBENCH_WITH_TBB
void run_beyond_the_limit_of_the_program() {
  for (const std::size_t limit : {4U, 2U, 3U}) {
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, limit);
    ThreadTeam(8).for_ranges(1000, [](Index, Index) {});
  }
  std::_Exit(0);
}

TEST(ThreadTeam, prints_nothing_where_the_program_allows_fewer_threads) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(run_beyond_the_limit_of_the_program(), testing::ExitedWithCode(0), "^$");
}
#endif

}  // namespace
}  // namespace thinbench::detail
