// thin() and Thinner: what rules say, and chosen variants. Golden compares thin() with recorded
// pixels.
#include "thinbench/thinning.hpp"

#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/filled_image.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "support/variant_of.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/nets.hpp"

namespace thinbench {
namespace {

TEST(Thin, does_what_a_rule_says_unless_told_otherwise) {
  const ByteImage image = noise_image(90, 30, 60, 3, 6);
  for (const NamedRule& named : named_rules()) {
    const Rule rule = Rule::named(named.name);
    for (const Thinning& thinning : {Thinning{}, Thinning{Border::foreground, 2}}) {
      const Border border = thinning.border.value_or(named.border);
      const Thinned expected = thinned_by_reference(
          rule, image, {border, thinning.max_iterations.value_or(named.max_iterations)});
      ByteImage out(90, 30);
      EXPECT_EQ(thin(rule, image.view(), out.view(), thinning), expected.iterations) << named.name;
      EXPECT_TRUE(equal(out.view(), expected.image.view())) << named.name;
    }
  }
}

TEST(Thinner, runs_a_net_that_equals_the_rule_as_the_rule) {
  const Rule rule = Rule::naccache_shinghal;
  const Rule net = Rule::from_net(kPaperTwoLayer, Activation::linear);
  for (const Index width : {600, 2048}) {
    const ByteImage image = noise_image(width, 70, 90, 2, 3);
    Thinner by_rule(rule, width, 70);
    Thinner by_net(net, width, 70);
    ByteImage expected(width, 70), out(width, 70);
    EXPECT_EQ(by_rule(image.view(), expected.view()), by_net(image.view(), out.view()));
    EXPECT_TRUE(equal(out.view(), expected.view())) << width;
  }
  EXPECT_EQ(&detail::thinning_variants(*detail::body_of(net)),
            &detail::thinning_variants(*detail::body_of(rule)));
}

TEST(Rule, of_a_net_reaches_the_adjacent_pixels) {
  EXPECT_EQ(Rule::from_net(kPaperTwoLayer, Activation::linear).reach(), 1);
  EXPECT_EQ(Rule::named("net_two_layer_linear").reach(), 1);
}

TEST(Thin, takes_one_iteration_for_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 7}, {7, 0}}) {
    for (const RuleInfo& info : kRules) {
      for (const Border border : {Border::background, Border::keep}) {
        EXPECT_EQ(thin(info.rule, ConstImageView(nullptr, width, height), {nullptr, width, height},
                       {border}),
                  1)
            << info.name;
      }
    }
  }
}

TEST(Thin, treats_any_nonzero_byte_as_foreground_and_writes_0_and_255) {
  const ByteImage bits = noise_image(70, 12, 90, 1, 3);
  const Thinned expected = thinned_by_reference(Rule::zhang_suen, bits);
  const ByteImage image = image_by(
      70, 12, [&](Index x, Index y) { return bits.at(x, y) != 0 ? 1 + (x * 7 + y) % 255 : 0; });
  ByteImage out = filled_image(70, 12, 0x5A);
  EXPECT_EQ(thin(Rule::zhang_suen, image.view(), out.view()), expected.iterations);
  EXPECT_TRUE(equal(out.view(), expected.image.view()));
}

bool has_row_kernel() {
  return best_isa() == Isa::avx512 || best_isa() == Isa::avx512icl;
}

TEST(Thin, takes_the_latest_isa_and_the_technique_by_width) {
  const auto& narrow = chosen_variant(Rule::naccache_shinghal, 100, 10);
  const auto& wide = chosen_variant(Rule::naccache_shinghal, 2000, 10);
  EXPECT_EQ(narrow.isa, best_isa());
  EXPECT_EQ(wide.isa, best_isa());
  EXPECT_EQ(narrow.technique, has_row_kernel() ? "simd_bitpacked_row" : "simd_bitpacked_tiles");
  EXPECT_EQ(wide.technique, "simd_bitpacked_tiles");
}

TEST(Thinner, works_after_moves) {
  static_assert(!std::is_copy_constructible_v<Thinner> && !std::is_copy_assignable_v<Thinner>);
  static_assert(std::is_nothrow_move_constructible_v<Thinner>);
  static_assert(std::is_nothrow_move_assignable_v<Thinner>);
  const ByteImage image = noise_image(60, 20, 90, 1, 4);
  const Thinned expected = thinned_by_reference(Rule::mb2, image);
  Thinner first(Rule::mb2, 60, 20);
  Thinner second(std::move(first));
  Thinner third(Rule::zhang_suen, 5, 5);
  third = std::move(second);
  ByteImage out(60, 20);
  EXPECT_EQ(third(image.view(), out.view()), expected.iterations);
  EXPECT_TRUE(equal(out.view(), expected.image.view()));
}

}  // namespace
}  // namespace thinbench
