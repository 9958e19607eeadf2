// The difference between Lü and Wang's rule and Zhang and Suen's.
#include <gtest/gtest.h>

#include "rules/rule_table.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

Index pixels_left(BuiltInRule rule, const ByteImage& image) {
  return count_foreground(thinned(rule, image));
}

TEST(LuWang, slanted_lines_two_pixels_wide_keep_their_length) {
  const ByteImage line = image_by(24, 24, [](Index x, Index y) {
    return y >= 2 && y < 22 && (x == y || x == y + 1) ? 255 : 0;
  });
  EXPECT_GE(pixels_left(Rule::lu_wang, line), 20);
  EXPECT_LT(pixels_left(Rule::zhang_suen, line), 20);
}

TEST(LuWang, squares_of_two_by_two_pixels_vanish) {
  EXPECT_EQ(pixels_left(Rule::lu_wang, image_of({"....", ".##.", ".##.", "...."})), 0);
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
