#include "thinning/plan.hpp"

#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "api/catalogue.hpp"
#include "harness/test_images.hpp"
#include "thinbench/batch.hpp"

namespace {
// Of all threads, counted by the replaced operators below. oneTBB takes the memory of its tasks
// from a pool of its own, which they do not see.
std::atomic<long> allocations = 0;
}  // namespace

// Not inlined, because GCC would then see memory from `new` go to `free` and warn. Every form that
// the tests use is replaced: memory must go back to where it came from.
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

const ThinningOperation& any_operation() {
  return thinning_operations().front();
}

TEST(ThinningPlan, running_allocates_nothing) {
  const ByteImage image = noise_image(300, 90, 97, 1, 5);
  ByteImage out(300, 90);
  for (const ThinningOperation& operation : thinning_operations()) {
    for (const ThinningVariant& variant : operation.variants) {
      if (!unavailable_reason(variant, 300).empty()) continue;
      ThinningPlan plan(operation, variant, 300, 90, {variant.threaded ? 3 : 1});
      if (variant.threaded) plan.run(image.view(), out.view());  // wakes the threads
      const long before = allocations;
      plan.run(image.view(), out.view());
      EXPECT_EQ(allocations, before) << technique_name(variant.technique);
    }
  }
}

TEST(ThinningBatch, running_allocates_nothing) {
  std::vector<std::uint8_t> pixels(50 * 28 * 28, 255);
  const StackView stack = {pixels.data(), 50, 28, 28, 28, 28 * 28};
  for (const ThinningOperation& operation : thinning_operations()) {
    for (const int threads : {1, 3}) {
      ThinningBatch batch(operation, 28, 28, {.threads = threads});
      batch.run(stack, stack);  // wakes the threads
      const long before = allocations;
      batch.run(stack, stack);
      EXPECT_EQ(allocations, before) << operation.name;
    }
  }
}

TEST(ThinningPlan, kernel_keeps_its_input_and_may_be_repeated) {
  const ByteImage image = noise_image(100, 40, 97, 1, 6);
  for (const ThinningVariant& variant : any_operation().variants) {
    if (!unavailable_reason(variant, 100).empty()) continue;
    ThinningPlan plan(any_operation(), variant, 100, 40, {2});
    plan.load(image.view());
    const int passes = plan.thin();
    ByteImage first(100, 40);
    plan.store(first.view());
    EXPECT_EQ(plan.thin(), passes);
    ByteImage second(100, 40);
    plan.store(second.view());
    EXPECT_TRUE(equal(first.view(), second.view())) << technique_name(variant.technique);
  }
}

TEST(ThinningPlan, source_and_destination_may_be_one_image) {
  const ByteImage image = noise_image(77, 30, 95, 1, 7);
  for (const ThinningVariant& variant : any_operation().variants) {
    if (!unavailable_reason(variant, 77).empty()) continue;
    ThinningPlan plan(any_operation(), variant, 77, 30);
    ByteImage apart(77, 30);
    plan.run(image.view(), apart.view());
    ByteImage in_place = copy_of(image.view());
    plan.run(in_place.view(), in_place.view());
    EXPECT_TRUE(equal(apart.view(), in_place.view())) << technique_name(variant.technique);
  }
}

TEST(ThinningPlan, refuses_what_it_cannot_run) {
  const ThinningVariant& variant = any_operation().variants.front();
  EXPECT_THROW(ThinningPlan(any_operation(), variant, -1, 5), std::invalid_argument);
  EXPECT_THROW(ThinningPlan(any_operation(), variant, Index{1} << 40, 2), std::invalid_argument);
  EXPECT_THROW(ThinningPlan(any_operation(), variant, PTRDIFF_MAX, PTRDIFF_MAX),
               std::invalid_argument);
  EXPECT_THROW(ThinningPlan(any_operation(), variant, 5, 5, {0}), std::invalid_argument);
  EXPECT_THROW(ThinningPlan(any_operation(), variant, 5, 5, {1025}), std::invalid_argument);
}

TEST(ThinningPlan, refuses_images_wider_than_the_variant) {
  for (const ThinningVariant& variant : any_operation().variants) {
    if (variant.technique != Technique::simd_bitpacked_row) continue;
    EXPECT_FALSE(unavailable_reason(variant, 513).empty());
    EXPECT_THROW(ThinningPlan(any_operation(), variant, 513, 5), std::invalid_argument);
  }
}

}  // namespace
}  // namespace thinbench
