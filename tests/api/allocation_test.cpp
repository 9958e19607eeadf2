// Thinning does not allocate memory while it runs.
#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/variant_of.hpp"
#include "thinbench/batch.hpp"
#include "thinbench/thinning.hpp"

namespace {
// Allocations by all threads, counted by the operators below. They do not see oneTBB's own memory
// pool, from which tasks are allocated.
std::atomic<long> allocations = 0;
}  // namespace

// Not inlined, because GCC would then warn that memory from `new` is passed to `free`. Every form
// that the tests use is replaced, so that new and delete match.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace thinbench {
namespace {

TEST(ThinningState, allocates_nothing_after_construction) {
  const ByteImage image = noise_image(300, 90, 97, 1, 5);
  ByteImage out(300, 90);
  for (const RuleInfo& info : kRules) {
    for (const Border border : {Border::background, Border::keep, Border::foreground}) {
      if (border == Border::foreground && Rule(info.rule).sub_iterations().empty()) continue;
      for_each_state(detail::thinning_parameters(info.rule, {.border = border}), 300, 90, 3,
                     [&](detail::ThinningState& state, const std::string& name) {
                       state.run(image.view(), out.view());  // starts the threads
                       const long before = allocations;
                       state.run(image.view(), out.view());
                       EXPECT_EQ(allocations, before) << info.name << " by " << name;
                     });
    }
  }
}

TEST(ThinningBatch, allocates_nothing_after_construction) {
  std::vector<std::uint8_t> pixels(50 * 28 * 28, 255);
  const StackView stack = {pixels.data(), 50, 28, 28, 28, 28 * 28};
  for (const RuleInfo& info : kRules) {
    for (const int threads : {1, 3}) {
      ThinningBatch batch(info.rule, 28, 28, {}, {.threads = threads});
      batch(stack, stack);  // starts the threads
      const long before = allocations;
      batch(stack, stack);
      EXPECT_EQ(allocations, before) << info.name;
    }
  }
}

TEST(AllocationCounter, counts_aligned_and_plain_allocations) {
  const long before = allocations;
  const ByteImage image(300, 90);
  const std::vector<int> numbers(5);
  const volatile int* const used = numbers.data();  // else Clang leaves the allocation out
  EXPECT_EQ(*used, 0);
  EXPECT_EQ(allocations, before + 2);
}

}  // namespace
}  // namespace thinbench
