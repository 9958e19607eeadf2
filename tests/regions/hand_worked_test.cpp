// Objects and holes of images that were worked by hand.
#include <utility>

#include <gtest/gtest.h>

#include "regions/all_finders.hpp"
#include "support/made_image.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

TEST(Holes, plate_with_two_holes_has_their_areas_centres_and_boxes) {
  const ByteImage image =
      image_of({".........", ".#######.", ".#.##..#.", ".####..#.", ".#######."});
  for_each_finder(image.view(), [](const Regions& found, const std::string& finder) {
    ASSERT_EQ(found.objects.size(), 1U) << finder;
    EXPECT_EQ(found.objects[0], (Region{23, 88, 58, 1, 1, 7, 4, 0})) << finder;
    ASSERT_EQ(found.holes.size(), 2U) << finder;
    EXPECT_EQ(found.holes[0], (Region{1, 2, 2, 2, 2, 2, 2, 1})) << finder;
    EXPECT_EQ(found.holes[1], (Region{4, 22, 10, 5, 2, 6, 3, 1})) << finder;
    EXPECT_EQ(found.holes[1].centre_x(), 5.5) << finder;
    EXPECT_EQ(found.holes[1].centre_y(), 2.5) << finder;
  });
}

TEST(Holes, object_inside_a_hole_is_a_separate_object) {
  const ByteImage image =
      image_of({"#######", "#.....#", "#.###.#", "#.#.#.#", "#.###.#", "#.....#", "#######"});
  for_each_finder(image.view(), [](const Regions& found, const std::string& finder) {
    ASSERT_EQ(found.objects.size(), 2U) << finder;
    ASSERT_EQ(found.holes.size(), 2U) << finder;
    EXPECT_EQ(found.objects[1].area, 8) << finder;
    EXPECT_EQ(found.holes[0].area, 16) << finder;  // without the object inside
    EXPECT_EQ(found.holes[0].enclosing_object, 1U) << finder;
    EXPECT_EQ(found.holes[1].area, 1) << finder;
    EXPECT_EQ(found.holes[1].enclosing_object, 2U) << finder;
  });
}

TEST(Holes, objects_are_8_connected_and_background_4_connected) {
  const ByteImage diamond = image_of({".#.", "#.#", ".#."});
  for_each_finder(diamond.view(), [](const Regions& found, const std::string& finder) {
    EXPECT_EQ(found.objects.size(), 1U) << finder;
    ASSERT_EQ(found.holes.size(), 1U) << finder;
    EXPECT_EQ(found.holes[0], (Region{1, 1, 1, 1, 1, 1, 1, 1})) << finder;
  });
}

TEST(Holes, background_that_touches_the_image_border_is_not_a_hole) {
  for (const ByteImage& image :
       {image_of({"#.#", "#.#", "###"}), image_of({"###", "..#", "###"}),
        image_of({"###", "#..", "###"}), image_of({"###", "#.#", "#.#"}),
        image_of({"...", "...", "..."}), image_of({"###", "###", "###"})}) {
    for_each_finder(image.view(), [](const Regions& found, const std::string& finder) {
      EXPECT_TRUE(found.holes.empty()) << finder;
    });
  }
}

TEST(Holes, are_numbered_by_their_first_pixels) {
  const ByteImage image = image_of(
      {"......###", "###...#.#", "#.#...###", "###......", "###..####", "#.#..#.##", "###..####"});
  for_each_finder(image.view(), [](const Regions& found, const std::string& finder) {
    ASSERT_EQ(found.objects.size(), 3U) << finder;
    ASSERT_EQ(found.holes.size(), 4U) << finder;
    const std::vector<std::uint32_t> enclosing = {
        found.holes[0].enclosing_object, found.holes[1].enclosing_object,
        found.holes[2].enclosing_object, found.holes[3].enclosing_object};
    EXPECT_EQ(enclosing, (std::vector<std::uint32_t>{1, 2, 2, 3})) << finder;
  });
}

TEST(Holes, region_merged_from_many_runs_has_correct_sums) {
  const ByteImage comb =
      image_of({"#.#.#.#.#", "#.#.#.#.#", "#########", "#.......#", "#.#.#.#.#", "#########"});
  for_each_finder(comb.view(), [](const Regions& found, const std::string& finder) {
    ASSERT_EQ(found.objects.size(), 1U) << finder;
    EXPECT_EQ(found.objects[0].area, 35) << finder;
    ASSERT_EQ(found.holes.size(), 1U) << finder;
    EXPECT_EQ(found.holes[0], (Region{11, 44, 37, 1, 3, 7, 4, 1})) << finder;
  });
}

TEST(Holes, wide_and_tall_images_do_not_overflow_narrow_sums) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{20000, 60}, {65534, 5}, {70000, 4}, {9, 3000}}) {
    const ByteImage image = image_by(width, height, [w = width, h = height](Index x, Index y) {
      return x == 0 || y == 0 || x == w - 1 || y == h - 1 || x == w / 2 ? 255 : 0;
    });
    const reference::Regions expected = reference::holes(image.view());
    ASSERT_EQ(expected.holes.size(), 2U);
    for_each_finder(image.view(),
                    [&, columns = width](const Regions& found, const std::string& finder) {
                      EXPECT_EQ(found.objects, expected.objects) << finder << " at " << columns;
                      EXPECT_EQ(found.holes, expected.holes) << finder << " at " << columns;
                    });
  }
}

}  // namespace
}  // namespace thinbench
