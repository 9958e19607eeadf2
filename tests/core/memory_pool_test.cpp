// Memory that threads keep.
#include "core/memory_pool.hpp"

#include <atomic>
#include <cstdint>
#include <cstring>
#include <future>
#include <initializer_list>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#if __has_include(<sys/wait.h>)
#include <sys/wait.h>
#include <unistd.h>
#endif

#include "core/byte_image.hpp"
#include "core/thread_team.hpp"
#include "thinbench/memory.hpp"

namespace thinbench::detail {
namespace {

class MemoryPool : public ::testing::Test {
 protected:
  void SetUp() override { release_memory(); }
  void TearDown() override { release_memory(); }
};

TEST_F(MemoryPool, blocks_are_aligned_distinct_and_used_again) {
  std::vector<void*> blocks;
  for (const std::size_t bytes : std::initializer_list<std::size_t>{1, 64, 100, 5000, 70000}) {
    blocks.push_back(take_block(bytes));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(blocks.back()) % kAlignment, 0U);
    std::memset(blocks.back(), 255, bytes);
  }
  for (void* const block : blocks) give_block(block);
  EXPECT_GE(kept_bytes(), std::size_t{75165});
  void* const again = take_block(70000);
  EXPECT_EQ(again, blocks.back());
  EXPECT_LT(kept_bytes(), std::size_t{70000});
  give_block(again);
  give_block(nullptr);
}

TEST_F(MemoryPool, a_small_request_leaves_a_large_block) {
  give_block(take_block(1 << 20));
  const std::size_t before = kept_bytes();
  void* const small = take_block(100);
  EXPECT_EQ(kept_bytes(), before);
  give_block(small);
}

TEST_F(MemoryPool, arrays_are_zeroed_whatever_was_there) {
  std::memset(make_uninitialised<std::uint8_t>(5000).get(), 255, 5000);
  ASSERT_GE(kept_bytes(), std::size_t{5000});
  const auto zeroed = make_aligned<std::uint8_t>(5000);
  EXPECT_EQ(kept_bytes(), std::size_t{0});
  for (std::size_t i = 0; i < 5000; ++i) ASSERT_EQ(zeroed[i], 0) << i;
}

TEST_F(MemoryPool, is_bounded_and_drops_what_it_kept_longest) {
  std::vector<void*> blocks;
  for (int i = 0; i < 12; ++i) blocks.push_back(take_block(std::size_t{1} << 20));
  for (void* const block : blocks) {
    give_block(block);
    EXPECT_LE(kept_bytes(), kMaxKeptBytes);
  }
  EXPECT_EQ(kept_bytes(), kMaxKeptBytes);
  give_block(take_block(kMaxKeptBytes + 1));
  EXPECT_EQ(kept_bytes(), kMaxKeptBytes) << "larger than all that may be kept";
  blocks.clear();
  for (std::size_t i = 0; i < kMaxKeptBlocks + 5; ++i) blocks.push_back(take_block(64));
  for (void* const block : blocks) give_block(block);
  EXPECT_EQ(kept_bytes(), 64 * kMaxKeptBlocks);
}

TEST_F(MemoryPool, is_released_on_request) {
  give_block(take_block(1000));
  EXPECT_GE(kept_bytes(), std::size_t{1000});
  release_memory();
  EXPECT_EQ(kept_bytes(), std::size_t{0});
}

TEST_F(MemoryPool, is_of_one_thread) {
  void* const block = take_block(1000);
  std::thread([block] {
    give_block(block);
    EXPECT_GE(kept_bytes(), std::size_t{1000});
  }).join();
  EXPECT_EQ(kept_bytes(), std::size_t{0});
}

TEST_F(MemoryPool, of_workers_is_released_by_any_thread_unless_they_work) {
  std::promise<void> works, released;
  std::thread worker([&] {
    const WorkerBlocks blocks;
    give_block(take_block(1000));
    works.set_value();
    released.get_future().wait();
    EXPECT_GE(kept_bytes(), std::size_t{1000});
  });
  works.get_future().wait();
  release_memory();
  released.set_value();
  worker.join();
  EXPECT_GE(kept_bytes(), std::size_t{1000}) << "after the thread's end";
  release_memory();
  EXPECT_EQ(kept_bytes(), std::size_t{0});
}

TEST_F(MemoryPool, of_workers_serves_the_next_worker) {
  void* first = nullptr;
  void* second = nullptr;
  for (void** block : {&first, &second}) {
    std::thread([block] {
      const WorkerBlocks blocks;
      *block = take_block(70000);
      give_block(*block);
    }).join();
  }
  EXPECT_EQ(first, second);
}

TEST_F(MemoryPool, of_the_workers_of_a_team_is_released_by_its_caller) {
  const ThreadTeam team(2);
  std::atomic<int> parts_of_worker = 0;
  while (parts_of_worker == 0) {
    team.for_ranges(2, [&, caller = std::this_thread::get_id()](Index, Index) {
      if (std::this_thread::get_id() == caller) {
        std::this_thread::yield();
        return;
      }
      give_block(take_block(1000));
      ++parts_of_worker;
    });
  }
  EXPECT_GE(kept_bytes(), std::size_t{1000});
  release_memory();
  EXPECT_EQ(kept_bytes(), std::size_t{0});
}

struct FreesLate {
  AlignedArray<int> array;
};

// Its destructor runs after the pool's, which is made later.
TEST_F(MemoryPool, blocks_may_be_freed_and_taken_while_a_thread_ends) {
  std::thread([] {
    thread_local FreesLate late;
    late.array = make_aligned<int>(300);
    EXPECT_EQ(late.array[299], 0);
  }).join();
}

#if __has_include(<sys/wait.h>)
TEST_F(MemoryPool, works_in_a_child_after_fork) {
  give_block(take_block(1000));
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    bool good = kept_bytes() >= 1000;
    const auto array = make_aligned<std::uint8_t>(1000);
    good = good && array[999] == 0 && kept_bytes() == 0;
    release_memory();
    _exit(good ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  EXPECT_GE(kept_bytes(), std::size_t{1000}) << "of the parent";
}
#endif

}  // namespace
}  // namespace thinbench::detail
