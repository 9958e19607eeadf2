// The choice among variants, on synthetic lists.
#include "core/variant.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace thinbench::detail {
namespace {

struct FakeState {
  struct Parameters {};
};
using FakeVariants = VariantList<FakeState>;

constexpr Index kLargeSide = 1024;  // of images that threads share

/// The technique that is chosen.
std::string_view chosen(FakeVariants variants, Index width, const Execution& execution = {},
                        Index height = 10) {
  return choose_variant(variants.take(), width, height, execution).technique;
}

/// All at the baseline, which is always available.
FakeVariants slow_fast_and_narrow() {
  FakeVariants list;
  list.add("slow", Isa::baseline, nullptr, {1});
  list.add("narrow", Isa::baseline, nullptr, {9, 512});
  list.add("fast", Isa::baseline, nullptr, {5});
  return list;
}

TEST(ChooseVariant, takes_the_highest_priority_that_fits) {
  EXPECT_EQ(chosen(slow_fast_and_narrow(), 512), "narrow");
  EXPECT_EQ(chosen(slow_fast_and_narrow(), 513), "fast") << "too wide for the fastest";
}

TEST(ChooseVariant, takes_the_first_of_equal_priorities) {
  FakeVariants list;
  list.add("first", Isa::baseline, nullptr, {1});
  list.add("second", Isa::baseline, nullptr, {1});
  EXPECT_EQ(chosen(std::move(list), 5), "first");
}

TEST(ChooseVariant, takes_a_threaded_variant_only_for_several_threads_and_large_images) {
  const auto chosen_of = [](Index width, Index height, int threads) {
    FakeVariants list = slow_fast_and_narrow();
    list.add("threaded", Isa::baseline, nullptr, {2}, true);
    return chosen(std::move(list), width, {.threads = threads}, height);
  };
  EXPECT_EQ(chosen_of(kLargeSide, kLargeSide, 2), "threaded");
  EXPECT_EQ(chosen_of(kLargeSide, kLargeSide, 1), "fast");
  EXPECT_EQ(chosen_of(kLargeSide, kLargeSide - 1, 2), "fast");
  EXPECT_EQ(chosen_of(Index{1} << 40, 0, 2), "fast");
  EXPECT_EQ(chosen_of(Index{1} << 19, Index{1} << 44, 2), "threaded");
}

TEST(ChooseVariant, takes_one_thread_where_no_variant_uses_several) {
  EXPECT_EQ(chosen(slow_fast_and_narrow(), kLargeSide, {.threads = 2}, kLargeSide), "fast");
}

TEST(ChooseVariant, takes_the_requested_isa_or_the_next_lower_one) {
  for (const Isa highest : all_isas()) {
    if (!isa_available(highest)) continue;
    FakeVariants all;
    for (const Isa isa : all_isas()) all.add(isa_name(isa), isa, nullptr, {});
    EXPECT_EQ(chosen(std::move(all), 5, {.isa = highest}), isa_name(highest));
    EXPECT_EQ(chosen(slow_fast_and_narrow(), 5, {.isa = highest}), "narrow");
  }
}

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
