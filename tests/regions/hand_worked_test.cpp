// Objects and holes of images that were worked by hand, by the reference, to which all variants are
// equal.

#include <gtest/gtest.h>

#include "holes.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

TEST(Holes, plate_with_two_holes_has_their_areas_centres_and_boxes) {
  const ByteImage image =
      image_of({".........", ".#######.", ".#.##..#.", ".####..#.", ".#######."});
  const reference::Regions found = reference::holes(image.view());
  ASSERT_EQ(found.objects.size(), 1U);
  EXPECT_EQ(found.objects[0], (Region{23, 88, 58, 1, 1, 7, 4, 0}));
  ASSERT_EQ(found.holes.size(), 2U);
  EXPECT_EQ(found.holes[0], (Region{1, 2, 2, 2, 2, 2, 2, 1}));
  EXPECT_EQ(found.holes[1], (Region{4, 22, 10, 5, 2, 6, 3, 1}));
  EXPECT_EQ(found.holes[1].centre_x(), 5.5);
  EXPECT_EQ(found.holes[1].centre_y(), 2.5);
}

TEST(Holes, object_inside_a_hole_is_a_separate_object) {
  const ByteImage image =
      image_of({"#######", "#.....#", "#.###.#", "#.#.#.#", "#.###.#", "#.....#", "#######"});
  const reference::Regions found = reference::holes(image.view());
  ASSERT_EQ(found.objects.size(), 2U);
  ASSERT_EQ(found.holes.size(), 2U);
  EXPECT_EQ(found.objects[1].area, 8);
  EXPECT_EQ(found.holes[0].area, 16);  // without the object inside
  EXPECT_EQ(found.holes[0].enclosing_object, 1U);
  EXPECT_EQ(found.holes[1].area, 1);
  EXPECT_EQ(found.holes[1].enclosing_object, 2U);
}

TEST(Holes, objects_are_8_connected_and_background_4_connected) {
  const ByteImage diamond = image_of({".#.", "#.#", ".#."});
  const reference::Regions found = reference::holes(diamond.view());
  EXPECT_EQ(found.objects.size(), 1U);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.holes[0], (Region{1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Holes, background_that_touches_the_image_border_is_not_a_hole) {
  for (const TextImage& image : {TextImage{"#.#", "#.#", "###"},
                                 {"###", "..#", "###"},
                                 {"###", "#..", "###"},
                                 {"###", "#.#", "#.#"},
                                 {"...", "...", "..."},
                                 {"###", "###", "###"}}) {
    EXPECT_TRUE(reference::holes(image_of(image).view()).holes.empty());
  }
}

TEST(Holes, are_numbered_by_their_first_pixels) {
  const ByteImage image = image_of(
      {"......###", "###...#.#", "#.#...###", "###......", "###..####", "#.#..#.##", "###..####"});
  const reference::Regions found = reference::holes(image.view());
  ASSERT_EQ(found.objects.size(), 3U);
  ASSERT_EQ(found.holes.size(), 4U);
  const std::vector<std::uint32_t> enclosing = {
      found.holes[0].enclosing_object, found.holes[1].enclosing_object,
      found.holes[2].enclosing_object, found.holes[3].enclosing_object};
  EXPECT_EQ(enclosing, (std::vector<std::uint32_t>{1, 2, 2, 3}));
}

TEST(Holes, region_merged_from_many_runs_has_correct_sums) {
  const ByteImage comb =
      image_of({"#.#.#.#.#", "#.#.#.#.#", "#########", "#.......#", "#.#.#.#.#", "#########"});
  const reference::Regions found = reference::holes(comb.view());
  ASSERT_EQ(found.objects.size(), 1U);
  EXPECT_EQ(found.objects[0].area, 35);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.holes[0], (Region{11, 44, 37, 1, 3, 7, 4, 1}));
}

}  // namespace
}  // namespace thinbench
