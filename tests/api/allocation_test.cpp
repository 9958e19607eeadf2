// Thinning does not allocate memory while it runs, and nothing does for images without pixels. What
// remains where memory is short.
#include <atomic>
#include <climits>
#include <cstdlib>
#include <functional>
#include <new>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/isa_tests.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/graph.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/many.hpp"
#include "thinbench/memory.hpp"
#include "thinbench/packed.hpp"
#include "thinbench/regions.hpp"
#include "thinbench/thinning.hpp"

namespace {
// Allocations by all threads, counted by the operators below. They do not see oneTBB's own memory
// pool, from which tasks are allocated.
std::atomic<long> allocations = 0;
std::atomic<long> deallocations = 0;
std::atomic<std::size_t> allocated_bytes = 0;
std::atomic<long> available = LONG_MAX;  // allocations until the one that fails

void count(std::size_t size) {
  if (available-- == 0) throw std::bad_alloc();
  ++allocations;
  allocated_bytes += size;
}

#ifdef _WIN32
void* aligned_memory(std::size_t align, std::size_t size) {
  return _aligned_malloc(size, align);
}
void free_aligned(void* memory) {
  _aligned_free(memory);
}
#else
void* aligned_memory(std::size_t align, std::size_t size) {
  return std::aligned_alloc(align, (size + align - 1) / align * align);
}
void free_aligned(void* memory) {
  std::free(memory);
}
#endif
}  // namespace

// Not inlined, because GCC would then warn that memory from `new` is passed to `free`. Every form
// that the tests use is replaced, so that new and delete match.
[[gnu::noinline]] void* operator new(std::size_t size) {
  count(size);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  count(size);
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = aligned_memory(align, size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  deallocations += memory != nullptr ? 1 : 0;
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  deallocations += memory != nullptr ? 1 : 0;
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  deallocations += memory != nullptr ? 1 : 0;
  free_aligned(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  deallocations += memory != nullptr ? 1 : 0;
  free_aligned(memory);
}

namespace thinbench {
namespace {

TEST(ThinningState, allocates_nothing_after_construction) {
  const ByteImage image = noise_image(300, 90, 97, 1, 5);
  ByteImage out(300, 90);
  for (const RuleAndBorder& tested : rules_and_borders()) {
    for_each_state(detail::thinning_parameters(tested.rule, {.border = tested.border}), 300, 90, 3,
                   [&](detail::ThinningState& state, const std::string& name) {
                     state.run(image.view(), out.view());  // starts the threads
                     const long before = allocations;
                     state.run(image.view(), out.view());
                     EXPECT_EQ(allocations, before) << tested.name << " by " << name;
                   });
  }
}

TEST(StackThinner, allocates_nothing_after_construction) {
  std::vector<std::uint8_t> pixels(50 * 28 * 28, 255);
  const StackView stack = {pixels.data(), 50, 28, 28, 28, 28 * 28};
  for (const RuleInfo& info : kRules) {
    for (const int threads : {1, 3}) {
      StackThinner thinner(info.rule, 28, 28, {}, {.threads = threads});
      thinner(stack, stack);  // starts the threads
      const long before = allocations;
      thinner(stack, stack);
      EXPECT_EQ(allocations, before) << info.name;
    }
  }
}

/// Every function that takes an image, on one of this size without pixels.
void call_all(Index width, Index height) {
  const ConstImageView source(nullptr, width, height);
  const ImageView destination(nullptr, width, height);
  const LabelView labels(nullptr, width, height);
  for (const auto& [name, rule, border] : rules_and_borders()) {
    const Thinning thinning = {border};
    const Execution execution = {.threads = 2};
    thin(rule, source, destination, thinning, execution);
    thin_packed(rule, ConstPackedView(nullptr, width, height, BitOrder::msb_first),
                {nullptr, width, height, BitOrder::msb_first}, thinning, execution);
    thin_stack(rule, {nullptr, 3, width, height}, {nullptr, 3, width, height}, thinning, execution);
    thin_many(rule, std::span(&source, 1), std::span(&destination, 1), thinning, execution);
  }
  thin_labels(Rule::guo_hall, labels, labels, {}, {.threads = 2});
  static_cast<void>(find_regions(source, {.threads = 2}));
  static_cast<void>(find_objects(source));
  static_cast<void>(euler_number(source));
  static_cast<void>(euler_number(source, Connectivity::four));
  fill_holes(source, destination);
  label_regions(source, labels);
  label_objects(source, labels, Connectivity::four);
  label_objects(source, labels, Connectivity::eight);
  label_image(source, labels, Connectivity::eight);
  for (const EdgeOperatorInfo& info : kEdgeOperators) detect_edges(info.op, source, destination);
  static_cast<void>(localise_objects(source));
  static_cast<void>(skeleton_graph(source));
  prune(source, destination, {});
  classify_pixels(source, destination, destination);
  static_cast<void>(full_blocks(source));
}

TEST(EmptyImages, of_any_width_and_height_take_little_memory) {
  constexpr Index huge = Index{1} << 29;
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, huge}, {huge, 0}}) {
    call_all(width, height);  // compiles the rules
    const std::size_t before = allocated_bytes;
    call_all(width, height);
    EXPECT_LT(allocated_bytes - before, std::size_t{1} << 22) << width << " x " << height;
  }
  const std::size_t before = allocated_bytes;
  squared_distances({nullptr, 0, kMaxDistanceSide}, {nullptr, 0, kMaxDistanceSide});
  squared_distances({nullptr, kMaxDistanceSide, 0}, {nullptr, kMaxDistanceSide, 0});
  EXPECT_LT(allocated_bytes - before, std::size_t{1} << 16);
}

/// Calls it with ever more allocations until none fails; `after_failure(i)` after the i-th.
template <class Call, class AfterFailure>
void fail_each_allocation(const Call& call, const AfterFailure& after_failure) {
  for (long i = 0;; ++i) {
    try {
      available = i;
      call();
      available = LONG_MAX;
      return;
    } catch (const std::bad_alloc&) {
      available = LONG_MAX;
      after_failure(i);
    }
  }
}

TEST(ShortMemory, leaves_an_image_that_is_pruned_in_place) {
  const ByteImage lines = noise_image(60, 40, 30, 1, 5);
  ByteImage image = noise_image(60, 40, 30, 1, 5);
  release_memory();
  fail_each_allocation(
      [&] { static_cast<void>(prune(image.view(), image.view(), {.min_length = 3})); },
      [&](long i) { EXPECT_TRUE(equal(image.view(), lines.view())) << "allocation " << i; });
  EXPECT_FALSE(equal(image.view(), lines.view()));
}

TEST(AllocationCounter, counts_aligned_and_plain_allocations) {
  release_memory();
  const long before = allocations;
  const ByteImage image(300, 90);
  const std::vector<int> numbers(5);
  const volatile int* const used = numbers.data();  // else Clang leaves the allocation out
  EXPECT_EQ(*used, 0);
  EXPECT_EQ(allocations, before + 2);
}

/// Calls of functions that make a state each; thinning is by an instruction set.
void call_on(const ByteImage& image, ByteImage& out, const Execution& thinning = {}) {
  thin(Rule::guo_hall, image.view(), out.view(), {}, thinning);
  fill_holes(image.view(), out.view());
  detect_edges(EdgeOperator::sobel, image.view(), out.view());
  static_cast<void>(find_objects(image.view()));
}

class KeptMemory : public IsaTest {};
INSTANTIATE_TEST_SUITE_P(Isa, KeptMemory, testing::ValuesIn(all_isas()), isa_test_name);

TEST_P(KeptMemory, serves_the_next_calls) {
  const Execution thinning = {.isa = GetParam()};
  const ByteImage image = noise_image(510, 412, 40, 9, 5);
  ByteImage out(510, 412);
  call_on(image, out, thinning);
  const std::size_t before = allocated_bytes;
  call_on(image, out, thinning);
  EXPECT_LT(allocated_bytes - before, std::size_t{1} << 15);
}

/// What a call allocates on up to so many threads, with nothing kept.
template <class Call>
std::size_t bytes_on(int threads, const Call& call) {
  call(Execution{.threads = threads});  // starts the threads
  release_memory();
  const std::size_t before = allocated_bytes;
  call(Execution{.threads = threads});
  release_memory();
  return allocated_bytes - before;
}

/// Tests run with at most eight threads.
TEST(ManyThreads, take_memory_for_those_that_exist) {
#ifndef THINBENCH_WITH_TBB
  GTEST_SKIP() << "all threads that are asked for exist";
#endif
  const ByteImage large = noise_image(1024, 1024, 40, 9, 5);
  ByteImage result(1024, 1024);
  std::vector<std::int32_t> numbers(1024 * 1024);
  const LabelView labels(numbers.data(), 1024, 1024);
  const Index side = 150;  // too wide for lanes
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(100 * side * side), 255);
  const StackView stack = {pixels.data(), 100, side, side, side, side * side};
  std::vector<ConstImageView> sources;
  std::vector<ImageView> list;
  for (Index i = 0; i < stack.count; ++i) list.push_back(stack.image(i));
  for (const ImageView& image : list) sources.emplace_back(image.data, side, side);
  const std::pair<const char*, std::function<void(const Execution&)>> calls[] = {
      {"stack", [&](const Execution& on) { thin_stack(Rule::mb2, stack, stack, {}, on); }},
      {"list", [&](const Execution& on) { thin_many(Rule::mb2, sources, list, {}, on); }},
      {"thin", [&](const Execution& on) { thin(Rule::mb2, large.view(), result.view(), {}, on); }},
      {"distances", [&](const Execution& on) { squared_distances(large.view(), labels, on); }},
      {"regions", [&](const Execution& on) { (void)find_regions(large.view(), on); }},
      {"labels", [&](const Execution& on) { label_regions(large.view(), labels, on); }}};
  for (const auto& [name, call] : calls) {
    EXPECT_LE(bytes_on(1000, call), 10 * bytes_on(1, call)) << name;
  }
}

TEST(KeptMemoryOfThread, is_freed_when_a_thread_ends) {
  const ByteImage image = noise_image(510, 412, 40, 9, 5);
  ByteImage out(510, 412);
  call_on(image, out);  // what lives as long as the program
  const long before = allocations - deallocations;
  long kept = 0;
  std::thread([&] {
    const long at_start = allocations - deallocations;
    call_on(image, out);
    kept = allocations - deallocations - at_start;
  }).join();
  EXPECT_GT(kept, 0);
  EXPECT_EQ(allocations - deallocations, before);
}

}  // namespace
}  // namespace thinbench
