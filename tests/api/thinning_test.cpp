// thin(), Thinner and thin_packed(): what rules say, chosen variants, packed images. Golden
// compares thin() with recorded pixels.
#include "thinbench/thinning.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/packed_image.hpp"
#include "support/reference_thinning.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "thinbench/many.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/nets.hpp"
#include "thinbench/packed.hpp"

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

TEST(Rule, of_a_net_has_the_nets_name) {
  EXPECT_EQ(Rule::from_net(kPaperTwoLayer, Activation::linear).name(), "net");
  EXPECT_EQ(Rule::named("net_two_layer_linear").name(), "net_two_layer_linear");
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

constexpr std::array kOrders = {BitOrder::msb_first, BitOrder::lsb_first};

class PackedThin : public testing::TestWithParam<RuleAndBorder> {};

TEST_P(PackedThin, equals_thin_of_bytes_in_both_bit_orders_at_any_width_and_stride) {
  const auto& [name, rule, border] = GetParam();
  for (const Index width : {1, 7, 8, 63, 64, 65, 133, 515, 1001}) {
    const ByteImage image = noise_image(width, 37, 80, 3, static_cast<std::uint64_t>(width));
    ByteImage expected(width, 37);
    const Thinning thinning = {border};
    const int iterations = thin(rule, image.view(), expected.view(), thinning);
    for (const BitOrder order : kOrders) {
      for (const Index gap : {0, 5}) {
        const PackedImage source(image.view(), order, gap, 0xFF);
        PackedImage result(width, 37, order, gap, 0xA5);
        EXPECT_EQ(thin_packed(rule, source.view(), result.view(), thinning), iterations);
        EXPECT_EQ(result, PackedImage(expected.view(), order, gap, 0xA5)) << width;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, PackedThin, all_rules_and_borders(), rule_and_border_test_name);

TEST(PackedThin, every_variant_gives_the_same_bits) {
  const ByteImage image = noise_image(1100, 1000, 60, 12, 17);
  const ByteImage expected = thinned(Rule::guo_hall, image);
  const PackedImage source(image.view(), BitOrder::msb_first);
  const PackedImage bits(expected.view(), BitOrder::lsb_first);
  for_each_state(detail::thinning_parameters(Rule::guo_hall, {}), 1100, 1000, 3,
                 [&](detail::ThinningState& state, const std::string& name) {
                   PackedImage result(1100, 1000, BitOrder::lsb_first);
                   state.run(source.view(), result.view());
                   EXPECT_EQ(result, bits) << name;
                 });
}

TEST(Thin, one_row_or_image_is_in_place_whatever_its_strides) {
  std::vector<std::uint8_t> row = {1, 1, 1, 0, 1, 1, 1};
  thin(Rule::named("guo_hall"), {row.data(), 7, 1, 700}, ImageView(row.data(), 7, 1));
  const std::vector<std::uint8_t> thinned = row;
  EXPECT_NE(thinned[0], 1) << "nothing was written";
  thin_stack(Rule::named("guo_hall"), ConstStackView(row.data(), 1, 7, 1, 700, 900),
             StackView(row.data(), 1, 7, 1));
  EXPECT_EQ(row, thinned);
}

TEST(PackedThin, works_in_place_and_from_one_bit_order_to_the_other) {
  const ByteImage image = noise_image(131, 50, 90, 2, 4);
  const ByteImage expected = thinned(Rule::zhang_suen, image);
  for (const BitOrder order : kOrders) {
    PackedImage bits(image.view(), BitOrder::msb_first, 3);
    PackedView to = bits.view();
    to.order = order;
    thin_packed(Rule::zhang_suen, bits.view(), to);
    EXPECT_EQ(bits.bytes(), PackedImage(expected.view(), order, 3).bytes());
  }
}

TEST(PackedThin, works_from_one_side_of_a_buffer_to_the_other) {
  const ByteImage image = noise_image(40, 30, 90, 2, 4);
  const PackedImage expected(thinned(Rule::guo_hall, image).view(), BitOrder::msb_first, 5);
  PackedImage both(image.view(), BitOrder::msb_first, 5);
  PackedView right = both.view();
  right.data += 5;
  thin_packed(Rule::guo_hall, both.view(), right);
  for (Index y = 0; y < 30; ++y) {
    EXPECT_TRUE(std::equal(right.row(y), right.row(y) + 5, expected.view().row(y))) << y;
  }
}

TEST(PackedThin, takes_one_iteration_for_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 7}, {7, 0}}) {
    EXPECT_EQ(
        thin_packed(Rule::guo_hall, ConstPackedView(nullptr, width, height, BitOrder::msb_first),
                    PackedView(nullptr, width, height, BitOrder::msb_first)),
        1);
  }
}

}  // namespace
}  // namespace thinbench
