// The reference of rules given as tables, on hand-worked images.

#include <bit>
#include <vector>

#include <gtest/gtest.h>

#include "support/reference_thinning.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

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
