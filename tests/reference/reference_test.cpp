// The meaning of border and max_iterations, tested on the references of all rules; the reference of
// rules given as tables, on images worked by hand.
#include <bit>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "support/reference_thinning.hpp"
#include "support/rule_parameters.hpp"

namespace thinbench {
namespace {

/// Noise, with foreground on all sides, and images that consist of their border.
std::vector<ByteImage> images() {
  std::vector<ByteImage> all;
  std::uint64_t seed = 40;
  for (const auto& [width, height] :
       {std::pair<Index, Index>{1, 1}, {1, 9}, {9, 1}, {2, 2}, {2, 7}, {3, 3}, {5, 4}, {31, 23}}) {
    for (const int percent : {55, 92, 100}) {
      all.push_back(noise_image(width, height, percent, 1, ++seed));
    }
  }
  return all;
}

bool is_on_border(const ByteImage& image, Index x, Index y) {
  return x == 0 || y == 0 || x == image.width() - 1 || y == image.height() - 1;
}

class Repetition : public testing::TestWithParam<Rule> {};

TEST_P(Repetition, keeps_the_border_on_request) {
  for (const ByteImage& image : images()) {
    for (const int limit : {1, 2, kUnlimited}) {
      const Thinned result = thinned_by_reference(GetParam(), image, {Border::keep, limit});
      for (Index y = 0; y < image.height(); ++y) {
        for (Index x = 0; x < image.width(); ++x) {
          if (!is_on_border(image, x, y)) continue;
          ASSERT_EQ(result.image.at(x, y), image.at(x, y)) << x << ", " << y;
        }
      }
    }
  }
}

TEST_P(Repetition, keeping_the_border_does_nothing_where_it_is_background) {
  for (const ByteImage& image : images()) {
    const ByteImage inner = image_by(image.width(), image.height(), [&](Index x, Index y) {
      return is_on_border(image, x, y) ? 0 : image.at(x, y);
    });
    EXPECT_TRUE(equal(thinned_by_reference(GetParam(), inner, {Border::keep}).image.view(),
                      thinned_by_reference(GetParam(), inner).image.view()));
  }
}

TEST_P(Repetition, repeated_single_iterations_equal_one_run) {
  for (const Border border : {Border::background, Border::keep}) {
    for (const ByteImage& image : images()) {
      const Thinned all = thinned_by_reference(GetParam(), image, {border});
      ByteImage current = copy_of(image.view());
      for (int done = 1; done <= all.iterations; ++done) {
        const Thinned next = thinned_by_reference(GetParam(), current, {border, 1});
        EXPECT_EQ(next.iterations, 1);
        EXPECT_EQ(equal(next.image.view(), current.view()), done == all.iterations)
            << "only the last iteration changes nothing";
        current = copy_of(next.image.view());
        const Thinned limited = thinned_by_reference(GetParam(), image, {border, done});
        EXPECT_EQ(limited.iterations, done);
        EXPECT_TRUE(equal(limited.image.view(), current.view()));
      }
      EXPECT_TRUE(equal(current.view(), all.image.view()));
    }
  }
}

TEST_P(Repetition, works_in_place) {
  for (const ByteImage& image : images()) {
    for (const Border border : {Border::background, Border::keep}) {
      const Thinned expected = thinned_by_reference(GetParam(), image, {border});
      ByteImage in_place = copy_of(image.view());
      EXPECT_EQ(reference_named(GetParam().name())({border}, in_place.view(), in_place.view()),
                expected.iterations);
      EXPECT_TRUE(equal(in_place.view(), expected.image.view()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, Repetition, testing::ValuesIn(all_rules()), rule_test_name);

TEST(ReferenceZhangSuen, removes_the_row_below_a_kept_border) {
  // Worked by hand: each inner pixel has five consecutive foreground neighbours and none below, so
  // the first sub-iteration removes it.
  ByteImage image = image_of({"#######", "#######", "......."});
  EXPECT_EQ(reference::thinning(Rule::zhang_suen)({Border::keep}, image.view(), image.view()), 2);
  EXPECT_EQ(text_of(image), (TextImage{"#######", "#.....#", "......."}));
}

using Tables = std::vector<WindowTable>;

Thinned applied(const Tables& tables, const ByteImage& image,
                const reference::Repetition& repetition) {
  Thinned result = {filled_image(image.width(), image.height(), 77), 0};
  result.iterations =
      reference::apply_tables(tables, repetition, image.view(), result.image.view());
  return result;
}

/// The pixel k of the window, k = 4 is the pixel itself.
Tables pixel_of_window(int k) {
  return {make_window_table([k](std::size_t window) { return window >> k & 1; })};
}

const Tables kErosion = {make_window_table([](std::size_t window) { return window == 511; })};
const Tables kLife = {make_window_table([](std::size_t window) {
  const int neighbours = std::popcount(window & ~(std::size_t{1} << 4));
  return neighbours == 3 || (neighbours == 2 && (window >> 4 & 1) != 0);
})};

const TextImage kFull = {"####", "####", "####", "####"};

TEST(CustomRuleReference, each_bit_of_a_window_is_one_pixel_in_raster_order) {
  const ByteImage image = image_of({".....", ".....", "..#..", ".....", "....."});
  for (int k = 0; k < 9; ++k) {
    const Thinned result = applied(pixel_of_window(k), image, {Border::background, 1});
    const Index x = 2 - (k % 3 - 1);
    const Index y = 2 - (k / 3 - 1);
    EXPECT_EQ(result.image.at(x, y), 255) << k;
    EXPECT_EQ(result.iterations, 1);
  }
}

TEST(CustomRuleReference, life_turns_a_line_and_ends_at_the_limit) {
  const ByteImage line = image_of({".....", ".....", ".###.", ".....", "....."});
  const TextImage turned = {".....", "..#..", "..#..", "..#..", "....."};
  const Thinned once = applied(kLife, line, {Border::background, 1});
  EXPECT_EQ(text_of(once.image), turned);
  const Thinned often = applied(kLife, line, {Border::background, 7});
  EXPECT_EQ(text_of(often.image), turned);
  EXPECT_EQ(often.iterations, 7);
}

TEST(CustomRuleReference, background_outside_erodes_the_border) {
  const Thinned once = applied(kErosion, image_of(kFull), {Border::background, 1});
  EXPECT_EQ(text_of(once.image), (TextImage{"....", ".##.", ".##.", "...."}));
  const Thinned all = applied(kErosion, image_of(kFull), {});
  EXPECT_EQ(text_of(all.image), (TextImage{"....", "....", "....", "...."}));
  EXPECT_EQ(all.iterations, 3);
}

TEST(CustomRuleReference, foreground_outside_does_not) {
  const Thinned full = applied(kErosion, image_of(kFull), {Border::foreground});
  EXPECT_EQ(text_of(full.image), kFull);
  EXPECT_EQ(full.iterations, 1);
  const ByteImage hole = image_of({"####", "####", "###.", "####"});
  const Thinned twice = applied(kErosion, hole, {Border::foreground, 2});
  EXPECT_EQ(text_of(twice.image), (TextImage{"#...", "#...", "#...", "#..."}));
}

TEST(CustomRuleReference, kept_border_neither_loses_nor_gains_pixels) {
  const ByteImage image = image_of({"#.#.#", ".....", "##.##", ".....", "#####"});
  const Tables all = {make_window_table([](std::size_t) { return true; })};
  const Tables none = {make_window_table([](std::size_t) { return false; })};
  EXPECT_EQ(text_of(applied(all, image, {Border::keep}).image),
            (TextImage{"#.#.#", ".###.", "#####", ".###.", "#####"}));
  EXPECT_EQ(text_of(applied(none, image, {Border::keep}).image),
            (TextImage{"#.#.#", ".....", "#...#", ".....", "#####"}));
}

TEST(CustomRuleReference, sub_iterations_follow_each_other) {
  const Tables shifts = {pixel_of_window(3).front(), pixel_of_window(5).front()};  // east, west
  const Thinned result = applied(shifts, image_of({"##..", "...#"}), {Border::background, 4});
  EXPECT_EQ(text_of(result.image), (TextImage{"##..", "...."}));
  EXPECT_EQ(result.iterations, 4);  // sub-iterations change pixels, though their iteration does not
}

}  // namespace
}  // namespace thinbench
