// fill_holes() and the Euler numbers.
#include "thinbench/regions.hpp"

#include <array>

#include <gtest/gtest.h>

#include "support/text_image.hpp"

namespace thinbench {
namespace {

TEST(EulerNumber, depends_on_the_connectivity) {
  const ByteImage diamond = image_of({".#.", "#.#", ".#."});
  EXPECT_EQ(euler_number(diamond.view()), 0) << "one object around one hole";
  EXPECT_EQ(euler_number(diamond.view(), Connectivity::four), 4)
      << "four objects, and all background is outside";
}

TEST(FillHoles, fills_holes_and_the_objects_inside_them) {
  const ByteImage image = image_of({"#####..", "#...#.#", "#.#.#..", "#...#..", "#####.."});
  const TextImage expected = {"#####..", "#####.#", "#####..", "#####..", "#####.."};
  ByteImage filled(image.width(), image.height());
  fill_holes(image.view(), filled.view());
  EXPECT_EQ(text_of(filled), expected);
  filled = copy_of(image.view());
  fill_holes(filled.view(), filled.view());
  EXPECT_EQ(text_of(filled), expected) << "in place";
}

TEST(FillHoles, depends_on_the_connectivity_of_objects) {
  const ByteImage image = image_of({".#.....", "#.#.###", ".#..#.#", "....###"});
  ByteImage filled(image.width(), image.height());
  fill_holes(image.view(), filled.view(), {Connectivity::four});
  EXPECT_EQ(text_of(filled), (TextImage{".#.....", "#.#.###", ".#..###", "....###"}));
  fill_holes(image.view(), filled.view(), {Connectivity::eight});
  EXPECT_EQ(text_of(filled), (TextImage{".#.....", "###.###", ".#..###", "....###"}));
}

TEST(FillHoles, fills_holes_up_to_an_area_without_the_objects_inside_them) {
  const ByteImage image = image_of({"#####..", "#...###", "#.#.#.#", "#...###", "#####.."});
  const TextImage small = {"#####..", "#...###", "#.#.###", "#...###", "#####.."};
  const TextImage all = {"#####..", "#######", "#######", "#######", "#####.."};
  ByteImage filled(image.width(), image.height());
  const auto filled_up_to = [&](std::int64_t area) {
    fill_holes(image.view(), filled.view(), {Connectivity::eight, area});
    return text_of(filled);
  };
  EXPECT_EQ(filled_up_to(0), text_of(image));
  EXPECT_EQ(filled_up_to(1), small);
  EXPECT_EQ(filled_up_to(7), small);
  EXPECT_EQ(filled_up_to(8), all);
  EXPECT_EQ(filled_up_to(kAnyHoleArea), all);
}

TEST(EulerNumber, of_one_row_takes_any_stride) {
  const std::array<std::uint8_t, 5> row = {0, 255, 0, 255, 255};
  EXPECT_EQ(euler_number({row.data(), 5, 1, PTRDIFF_MAX}), 2);
}

}  // namespace
}  // namespace thinbench
