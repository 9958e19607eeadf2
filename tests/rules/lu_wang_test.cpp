// The difference between Lü and Wang's rule and Zhang and Suen's.
#include <gtest/gtest.h>

#include "rules/rule_table.hpp"
#include "support/byte_image.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

/// A slanted line two pixels wide.
ByteImage slanted_line(Index length) {
  ByteImage image(length + 4, length + 4);
  for (Index i = 0; i < length; ++i) {
    image.at(i + 2, i + 2) = 255;
    image.at(i + 3, i + 2) = 255;
  }
  return image;
}

Index foreground_pixels(BuiltInRule rule, const ByteImage& image) {
  ByteImage skeleton(image.width(), image.height());
  thin(rule, image.view(), skeleton.view());
  Index count = 0;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) count += skeleton.at(x, y) != 0 ? 1 : 0;
  }
  return count;
}

TEST(LuWang, slanted_lines_two_pixels_wide_keep_their_length) {
  const ByteImage line = slanted_line(20);
  EXPECT_GE(foreground_pixels(Rule::lu_wang, line), 20);
  EXPECT_LT(foreground_pixels(Rule::zhang_suen, line), 20);
}

TEST(LuWang, squares_of_two_by_two_pixels_vanish) {
  ByteImage square(4, 4);
  for (const Index y : {1, 2}) {
    for (const Index x : {1, 2}) square.at(x, y) = 255;
  }
  EXPECT_EQ(foreground_pixels(Rule::lu_wang, square), 0);
}

/// Over all neighbourhoods: pixels with two foreground neighbours are kept, all others treated as
/// by Zhang and Suen's rule.
template <int sub>
void expect_difference_at_two_neighbours() {
  const auto lu_wang = detail::make_rule_table<detail::LuWang, sub>();
  const auto zhang_suen = detail::make_rule_table<detail::ZhangSuen, sub>();
  for (std::size_t k = 0; k < 512; ++k) {
    const bool has_two = k >= 256 && __builtin_popcountll(k & 255) == 2;
    EXPECT_EQ(lu_wang[k], has_two ? 1 : zhang_suen[k]) << k;
  }
}

TEST(LuWang, differs_from_zhang_suen_only_where_a_pixel_has_two_neighbours) {
  expect_difference_at_two_neighbours<0>();
  expect_difference_at_two_neighbours<1>();
}

}  // namespace
}  // namespace thinbench
