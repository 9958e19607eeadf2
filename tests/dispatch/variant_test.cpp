// The choice among variants, on synthetic lists.
#include "core/variant.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/rejection.hpp"

namespace thinbench::detail {
namespace {

using enum Technique;

// All at the baseline, which is always available.
constexpr VariantInfo kSlow = {.technique = lut, .isa = Isa::baseline, .priority = 1};
constexpr VariantInfo kThreaded = {
    .technique = lut, .isa = Isa::baseline, .threaded = true, .priority = 1};
constexpr VariantInfo kFast = {.technique = bitpacked, .isa = Isa::baseline, .priority = 5};
constexpr VariantInfo kNarrow = {
    .technique = simd_bytes, .isa = Isa::baseline, .max_width = 512, .priority = 9};
constexpr VariantInfo kBackgroundOnly = {
    .technique = autovec, .isa = Isa::baseline, .keeps_border = false, .priority = 7};

std::size_t chosen(const std::vector<VariantInfo>& variants, Index width,
                   const Options& options = {}) {
  return choose_variant("thin_it", std::span<const VariantInfo>(variants), width, options);
}

std::string rejection(const std::vector<VariantInfo>& variants, Index width,
                      const Options& options) {
  return rejection_of([&] { static_cast<void>(chosen(variants, width, options)); });
}

TEST(ChooseVariant, takes_the_highest_priority_that_fits) {
  EXPECT_EQ(chosen({kSlow, kFast, kNarrow}, 512), 2U);
  EXPECT_EQ(chosen({kSlow, kFast, kNarrow}, 513), 1U) << "too wide for the fastest";
  EXPECT_EQ(chosen({kNarrow, kFast, kSlow}, 512), 0U) << "the order of the list does not matter";
}

TEST(ChooseVariant, takes_the_first_of_equal_priorities) {
  EXPECT_EQ(chosen({kSlow, kSlow}, 5), 0U);
}

TEST(ChooseVariant, keeps_the_border_only_with_variants_that_can) {
  EXPECT_EQ(chosen({kFast, kBackgroundOnly}, 5), 1U);
  EXPECT_EQ(chosen({kFast, kBackgroundOnly}, 5, {.border = Border::keep}), 0U);
  EXPECT_EQ(rejection({kBackgroundOnly}, 5, {.border = Border::keep}),
            "thin_it by any technique at any instruction set on one thread: it does not keep the "
            "border");
}

TEST(ChooseVariant, takes_a_threaded_variant_only_for_several_threads) {
  EXPECT_EQ(chosen({kSlow, kThreaded, kFast}, 5, {.threads = 2}), 1U);
  EXPECT_EQ(chosen({kThreaded, kSlow}, 5), 1U);
}

TEST(ChooseVariant, error_lists_the_existing_techniques_or_isas) {
  const std::vector<VariantInfo> variants = {kSlow, kFast};
  EXPECT_EQ(rejection(variants, 5, {.technique = simd_runs}),
            "thin_it by simd_runs at any instruction set on one thread: there is no such variant; "
            "its techniques are lut, bitpacked");
  EXPECT_EQ(rejection(variants, 5, {.isa = Isa::avx2}),
            "thin_it by any technique at avx2 on one thread: there is no such variant; its "
            "instruction sets are baseline");
  EXPECT_EQ(rejection(variants, 5, {.threads = 2, .technique = lut}),
            "thin_it by lut at any instruction set with threads: there is no such variant; it runs "
            "on one thread only");
}

TEST(ChooseVariant, error_names_the_width_limit) {
  EXPECT_EQ(rejection({kNarrow}, 513, {}),
            "thin_it by any technique at any instruction set on one thread: wider than this "
            "variant's limit of 512 pixels");
}

struct FakeState {
  using Setting = int;
};

TEST(VariantList, ranks_every_variant_of_a_later_isa_above_all_of_an_earlier_one) {
  VariantList<FakeState> list;
  list.add(lut, Isa::avx2, nullptr, {0});
  list.add_with_threads(bitpacked, Isa::sse42, nullptr, {kPrioritiesPerIsa - 1, 512, false});
  const std::vector<Variant<FakeState>> variants = list.take();
  ASSERT_EQ(variants.size(), 3U);
  EXPECT_GT(variants[0].priority, variants[1].priority);
  EXPECT_EQ(variants[1].max_width, 512);
  EXPECT_FALSE(variants[1].keeps_border);
  EXPECT_FALSE(variants[1].threaded);
  EXPECT_TRUE(variants[2].threaded);
}

}  // namespace
}  // namespace thinbench::detail
