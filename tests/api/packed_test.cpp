// thin() of packed images: equal to thin() of bytes; rejected arguments.
#include "thinbench/packed.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/packed_image.hpp"
#include "support/rejection.hpp"
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
        EXPECT_EQ(thin(rule, source.view(), result.view(), thinning), iterations);
        EXPECT_EQ(result, PackedImage(expected.view(), order, gap, 0xA5)) << width;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, PackedThin, all_rules_and_borders(), rule_and_border_test_name);

TEST(PackedThin, every_variant_gives_the_same_bits) {
  const ByteImage image = noise_image(1100, 1000, 60, 12, 17);
  ByteImage expected(1100, 1000);
  thin(Rule::guo_hall, image.view(), expected.view());
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
  ByteImage expected(131, 50);
  thin(Rule::zhang_suen, image.view(), expected.view());
  for (const BitOrder order : kOrders) {
    PackedImage bits(image.view(), BitOrder::msb_first, 3);
    PackedView to = bits.view();
    to.order = order;
    thin(Rule::zhang_suen, bits.view(), to);
    EXPECT_EQ(bits.bytes(), PackedImage(expected.view(), order, 3).bytes());
  }
}

TEST(PackedThin, takes_one_iteration_for_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 7}, {7, 0}}) {
    EXPECT_EQ(thin(Rule::guo_hall, ConstPackedView(nullptr, width, height, BitOrder::msb_first),
                   PackedView(nullptr, width, height, BitOrder::msb_first)),
              1);
  }
}

std::string rejected(const ConstPackedView& source, const PackedView& destination,
                     const Thinning& thinning = {}, const Execution& execution = {}) {
  return rejection_of([&] { thin(Rule::guo_hall, source, destination, thinning, execution); });
}

TEST(PackedThin, rejects_invalid_views_and_options_and_writes_nothing) {
  constexpr BitOrder order = BitOrder::msb_first;
  std::vector<std::uint8_t> bytes(100, 0x5A);
  std::uint8_t* const data = bytes.data();
  const PackedView to(data, 20, 10, order);
  const std::vector<std::uint8_t> other(100, 0xFF);
  const ConstPackedView from(other.data(), 20, 10, order);
  EXPECT_EQ(rejected({other.data(), 20, 9, order}, to),
            "source is 20 x 9 and destination 20 x 10; they must have the same size");
  EXPECT_EQ(rejected({other.data(), -1, 9, 8, order}, to), "source has the size -1 x 9");
  EXPECT_EQ(rejected({other.data(), 20, 10, 2, order}, to),
            "source has a stride of 2 bytes; its rows of 20 pixels take 3");
  EXPECT_EQ(rejected(from, {data, 20, 10, 2, order}),
            "destination has a stride of 2 bytes; its rows of 20 pixels take 3");
  EXPECT_EQ(rejected({nullptr, 20, 10, order}, to), "source has no data");
  EXPECT_EQ(rejected(from, {data, 20, 10, static_cast<BitOrder>(2)}),
            "destination has the bit order 2; expected msb_first or lsb_first");
  EXPECT_EQ(rejected({data + 1, 20, 10, order}, to),
            "source and destination overlap without being the same image");
  EXPECT_EQ(rejected(from, to, {}, {.threads = 0}),
            "threads: expected an integer in [1, 1024], got 0");
  EXPECT_EQ(rejected(from, to, {.max_iterations = 0}),
            "max_iterations: expected an integer of at least 1, got 0");
  EXPECT_EQ(bytes, std::vector<std::uint8_t>(100, 0x5A));
}

}  // namespace
}  // namespace thinbench
