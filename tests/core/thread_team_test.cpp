#include "core/thread_team.hpp"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#include <unistd.h>
#endif
#ifdef THINBENCH_WITH_TBB
#include <dlfcn.h>
#include <pthread.h>
#include <tbb/global_control.h>

#include "core/startable_threads.hpp"
#endif

#if defined(THINBENCH_WITH_TBB) && !defined(THINBENCH_SANITIZED)  // sanitizers replace it, too
namespace {
std::atomic<int> started = 0;
std::atomic<int> startable = INT_MAX;  // until none is
}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*run)(void*), void* argument) {
  static const auto create =
      reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  if (startable-- <= 0) return EAGAIN;
  ++started;
  return create(thread, attributes, run, argument);
}
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

TEST(ThreadTeam, has_no_more_threads_than_are_available) {
  EXPECT_EQ(available_threads(3), 3);
  EXPECT_EQ(ThreadTeam(3).threads(), 3);
  EXPECT_EQ(ThreadTeam(200).threads(), available_threads(200));
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

TEST(ThreadTeamDeathTest, runs_with_fewer_threads_where_the_system_does_not_start_more) {
#ifdef THINBENCH_SANITIZED
  GTEST_SKIP() << "sanitizers need address space without a limit";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(run_with_little_memory(8), testing::ExitedWithCode(0), "^$");
}
#endif

#ifdef THINBENCH_WITH_TBB
#ifndef THINBENCH_SANITIZED
/// Leaves with 0 if threads are tried again only where a limit has changed.
void start_more_threads_than_the_system_does() {
  startable = 5;
  bool good = startable_threads(8) == 3 && started == 5;
  startable = INT_MAX;
  good = good && startable_threads(8) == 3 && startable_threads(100) == 3 && started == 5;
  rlimit processes{};
  getrlimit(RLIMIT_NPROC, &processes);
  processes.rlim_cur = processes.rlim_max == RLIM_INFINITY ? 60000 : processes.rlim_max - 1;
  good = good && setrlimit(RLIMIT_NPROC, &processes) == 0;
  good = good && startable_threads(8) == 8 && started == 12 && startable_threads(7) == 7;
  std::_Exit(good && started == 12 ? 0 : 1);
}

TEST(ThreadTeamDeathTest, tries_to_start_more_threads_only_when_a_limit_has_changed) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(start_more_threads_than_the_system_does(), testing::ExitedWithCode(0), "^$");
}
#endif

void run_beyond_the_limit_of_the_program() {
  for (const std::size_t limit : {4U, 2U, 3U}) {
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, limit);
    ThreadTeam(8).for_ranges(1000, [](Index, Index) {});
  }
  std::_Exit(0);
}

TEST(ThreadTeamDeathTest, prints_nothing_where_the_program_allows_fewer_threads) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(run_beyond_the_limit_of_the_program(), testing::ExitedWithCode(0), "^$");
}
#endif

}  // namespace
}  // namespace thinbench::detail
