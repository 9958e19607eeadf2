// thin_packed(): equal to thin() of bytes.
#include "thinbench/packed.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/packed_image.hpp"
#include "support/rule_parameters.hpp"
#include "support/variant_of.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

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
