// Tables in other orders of pixels.

#include <vector>

#include <gtest/gtest.h>

#include "rules/recorded_tables.hpp"
#include "support/rejection.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using Values = std::vector<std::uint8_t>;

/// 512 values that are 1 where bit `bit` of the index is.
Values values_of_bit(int bit) {
  Values values(512);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<std::uint8_t>(i >> bit & 1);
  }
  return values;
}

WindowTable pixel_table(std::size_t k) {
  return make_window_table([k](std::size_t window) { return window >> k & 1; });
}

TEST(TableOrders, each_bit_is_one_pixel) {
  constexpr std::size_t kByColumns[] = {0, 3, 6, 1, 4, 7, 2, 5, 8};
  for (int bit = 0; bit < 9; ++bit) {
    const Values values = values_of_bit(bit);
    EXPECT_EQ(table_from_values(values, WindowOrder::raster),
              pixel_table(static_cast<std::size_t>(bit)));
    EXPECT_EQ(table_from_values(values, WindowOrder::matlab), pixel_table(kByColumns[bit]));
    EXPECT_EQ(table_from_values(values, WindowOrder::octave), pixel_table(kByColumns[8 - bit]));
  }
}

TEST(TableOrders, the_exceptions_of_hbreak_in_octaves_order) {
  Values values = values_of_bit(4);
  values[381] = values[471] = 0;  // as Octave's bwmorph writes them, from 1: 382 and 472
  const WindowTable hbreak = find_named_rule("hbreak")->sub_iterations.front();
  EXPECT_EQ(table_from_values(values, WindowOrder::octave), hbreak);
}

TEST(TableOrders, removals_name_the_neighbour_of_each_bit) {
  for (const NeighbourOrder& order : {kDescriptorOrder, kClockwiseOrder, kRasterOrder}) {
    for (std::size_t bit = 0; bit < 8; ++bit) {
      Values removed(256);
      for (std::size_t i = 0; i < 256; ++i) removed[i] = static_cast<std::uint8_t>(i >> bit & 1);
      const std::size_t pixel = order[bit];
      EXPECT_EQ(table_from_removals(removed, order), make_window_table([&](std::size_t window) {
                  return (window >> 4 & 1) != 0 && (window >> pixel & 1) == 0;
                }));
    }
  }
}

TEST(TableOrders, tables_of_scikit_image_are_those_of_its_rule) {
  const nlohmann::json digits = recorded().at("skimage").at("thin");
  const auto tables = find_named_rule("thin")->sub_iterations;
  ASSERT_EQ(tables.size(), digits.size());
  for (std::size_t sub = 0; sub < tables.size(); ++sub) {
    EXPECT_EQ(table_from_removals(bits_of(digits.at(sub)), kDescriptorOrder), tables[sub]);
  }
}

TEST(TableOrders, errors_name_size_position_and_value) {
  const auto error = [](const Values& values) {
    return rejection_of([&] { return table_from_values(values, WindowOrder::matlab); });
  };
  Values values(512);
  values[17] = 2;
  EXPECT_EQ(error(values), "value 18 of 512: expected 0 or 1, got 2");
  EXPECT_EQ(error(Values(256)), "expected 512 values, got 256");
  EXPECT_EQ(rejection_of([] { return table_from_removals(Values(512), kRasterOrder); }),
            "expected 256 values, got 512");
  for (const NeighbourOrder& order :
       {NeighbourOrder{0, 1, 2, 3, 4, 5, 6, 7}, NeighbourOrder{0, 1, 2, 3, 5, 6, 7, 7},
        NeighbourOrder{0, 1, 2, 3, 5, 6, 7, 200}}) {
    EXPECT_EQ(rejection_of([&] { return table_from_removals(Values(256), order); }),
              "an order of neighbours must name each of the pixels 0 to 3 and 5 to 8 once");
  }
}

}  // namespace
}  // namespace thinbench
