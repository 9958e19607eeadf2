// The choice among variants, on synthetic lists.
#include "core/variant.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/rejection.hpp"

namespace thinbench::detail {
namespace {

// All at the baseline, which is always available.
constexpr VariantInfo kSlow = {.technique = "slow", .isa = Isa::baseline, .priority = 1};
constexpr VariantInfo kThreaded = {
    .technique = "slow", .isa = Isa::baseline, .threaded = true, .priority = 1};
constexpr VariantInfo kFast = {.technique = "fast", .isa = Isa::baseline, .priority = 5};
constexpr VariantInfo kNarrow = {
    .technique = "narrow", .isa = Isa::baseline, .max_width = 512, .priority = 9};

constexpr Index kLargeSide = 1024;  // of images that threads share

std::size_t chosen(const std::vector<VariantInfo>& variants, Index width,
                   const Execution& execution = {}, Index height = 10) {
  return choose_variant("thin_it", variants, width, height, execution);
}

std::string rejection(const std::vector<VariantInfo>& variants, Index width,
                      const Execution& execution) {
  return rejection_of([&] { static_cast<void>(chosen(variants, width, execution, kLargeSide)); });
}

TEST(ChooseVariant, takes_the_highest_priority_that_fits) {
  EXPECT_EQ(chosen({kSlow, kFast, kNarrow}, 512), 2U);
  EXPECT_EQ(chosen({kSlow, kFast, kNarrow}, 513), 1U) << "too wide for the fastest";
  EXPECT_EQ(chosen({kNarrow, kFast, kSlow}, 512), 0U) << "the order of the list does not matter";
}

TEST(ChooseVariant, takes_the_first_of_equal_priorities) {
  EXPECT_EQ(chosen({kSlow, kSlow}, 5), 0U);
}

TEST(ChooseVariant, takes_a_threaded_variant_only_for_several_threads_and_large_images) {
  const std::vector<VariantInfo> variants = {kSlow, kThreaded, kFast};
  EXPECT_EQ(chosen(variants, kLargeSide, {.threads = 2}, kLargeSide), 1U);
  EXPECT_EQ(chosen(variants, kLargeSide, {}, kLargeSide), 2U);
  EXPECT_EQ(chosen(variants, kLargeSide, {.threads = 2}, kLargeSide - 1), 2U);
  EXPECT_EQ(chosen(variants, Index{1} << 40, {.threads = 2}, 0), 2U);
  EXPECT_EQ(chosen(variants, Index{1} << 19, {.threads = 2}, Index{1} << 44), 1U);
}

TEST(ChooseVariant, takes_one_thread_where_no_variant_uses_several) {
  EXPECT_EQ(chosen({kSlow, kFast}, kLargeSide, {.threads = 2}, kLargeSide), 1U);
}

TEST(ChooseVariant, rejects_threads_out_of_range) {
  for (const int threads : {0, kMaxThreads + 1}) {
    EXPECT_EQ(rejection({kSlow}, 5, {.threads = threads}),
              "threads: expected an integer in [1, 1024], got " + std::to_string(threads));
  }
}

TEST(ChooseVariant, error_lists_the_existing_isas) {
  EXPECT_EQ(rejection({kSlow, kFast}, 5, {.isa = Isa::avx2}),
            "thin_it at avx2 on one thread: its instruction sets are baseline");
  EXPECT_EQ(rejection({kSlow, kThreaded}, kLargeSide, {.threads = 2, .isa = Isa::avx2}),
            "thin_it at avx2 with threads: its instruction sets are baseline");
}

TEST(ChooseVariant, error_names_the_width_limit) {
  EXPECT_EQ(rejection({kNarrow}, 513, {}),
            "thin_it at any instruction set on one thread: wider than this variant's limit of 512 "
            "pixels");
}

struct FakeState {
  struct Parameters {};
};

TEST(VariantList, ranks_every_variant_of_a_later_isa_above_all_of_an_earlier_one) {
  VariantList<FakeState> list;
  list.add("first", Isa::avx2, nullptr, {0});
  list.add_with_threads("second", Isa::sse42, nullptr, {kPrioritiesPerIsa - 1, 512});
  const std::vector<Variant<FakeState>> variants = list.take();
  ASSERT_EQ(variants.size(), 3U);
  EXPECT_GT(variants[0].priority, variants[1].priority);
  EXPECT_EQ(variants[1].max_width, 512);
  EXPECT_FALSE(variants[1].threaded);
  EXPECT_TRUE(variants[2].threaded);
}

}  // namespace
}  // namespace thinbench::detail
