// Small pictures whose objects and holes were counted by hand.
#include <gtest/gtest.h>

#include "regions/pictures.hpp"

namespace thinbench {
namespace {

using holes_test::picture;
using holes_test::with_every_way;

TEST(Holes, plate_with_two_holes_has_their_areas_centres_and_boxes) {
  const ByteImage image =
      picture({".........", ".#######.", ".#.##..#.", ".####..#.", ".#######."});
  with_every_way(image.view(), [](const Regions& found, const std::string& way) {
    ASSERT_EQ(found.objects.size(), 1U) << way;
    EXPECT_EQ(found.objects[0], (Region{23, 88, 58, 1, 1, 7, 4, 0})) << way;
    ASSERT_EQ(found.holes.size(), 2U) << way;
    EXPECT_EQ(found.holes[0], (Region{1, 2, 2, 2, 2, 2, 2, 1})) << way;
    EXPECT_EQ(found.holes[1], (Region{4, 22, 10, 5, 2, 6, 3, 1})) << way;
    EXPECT_EQ(found.holes[1].centre_x(), 5.5) << way;
    EXPECT_EQ(found.holes[1].centre_y(), 2.5) << way;
  });
}

TEST(Holes, object_inside_a_hole_is_an_object_of_its_own_and_no_part_of_the_hole) {
  const ByteImage image =
      picture({"#######", "#.....#", "#.###.#", "#.#.#.#", "#.###.#", "#.....#", "#######"});
  with_every_way(image.view(), [](const Regions& found, const std::string& way) {
    ASSERT_EQ(found.objects.size(), 2U) << way;
    ASSERT_EQ(found.holes.size(), 2U) << way;
    EXPECT_EQ(found.objects[1].area, 8) << way;
    EXPECT_EQ(found.holes[0].area, 16) << way;  // the ring of light alone
    EXPECT_EQ(found.holes[0].enclosing_object, 1U) << way;
    EXPECT_EQ(found.holes[1].area, 1) << way;
    EXPECT_EQ(found.holes[1].enclosing_object, 2U) << way;
  });
}

TEST(Holes, objects_touch_at_corners_and_background_does_not) {
  const ByteImage diamond = picture({".#.", "#.#", ".#."});
  with_every_way(diamond.view(), [](const Regions& found, const std::string& way) {
    EXPECT_EQ(found.objects.size(), 1U) << way;
    ASSERT_EQ(found.holes.size(), 1U) << way;
    EXPECT_EQ(found.holes[0], (Region{1, 1, 1, 1, 1, 1, 1, 1})) << way;
  });
}

TEST(Holes, light_that_reaches_the_border_is_no_hole) {
  for (const ByteImage& image : {picture({"#.#", "#.#", "###"}), picture({"###", "..#", "###"}),
                                 picture({"###", "#..", "###"}), picture({"###", "#.#", "#.#"}),
                                 picture({"...", "...", "..."}), picture({"###", "###", "###"})}) {
    with_every_way(image.view(), [](const Regions& found, const std::string& way) {
      EXPECT_TRUE(found.holes.empty()) << way;
    });
  }
}

TEST(Holes, are_numbered_by_their_first_pixels_across_objects) {
  const ByteImage image = picture(
      {"......###", "###...#.#", "#.#...###", "###......", "###..####", "#.#..#.##", "###..####"});
  with_every_way(image.view(), [](const Regions& found, const std::string& way) {
    ASSERT_EQ(found.objects.size(), 3U) << way;
    ASSERT_EQ(found.holes.size(), 4U) << way;
    const std::vector<std::uint32_t> owners = {found.holes[0].enclosing_object, found.holes[1].enclosing_object,
                                               found.holes[2].enclosing_object, found.holes[3].enclosing_object};
    EXPECT_EQ(owners, (std::vector<std::uint32_t>{1, 2, 2, 3})) << way;
  });
}

TEST(Holes, region_that_grows_together_from_many_beginnings_keeps_the_first) {
  const ByteImage comb =
      picture({"#.#.#.#.#", "#.#.#.#.#", "#########", "#.......#", "#.#.#.#.#", "#########"});
  with_every_way(comb.view(), [](const Regions& found, const std::string& way) {
    ASSERT_EQ(found.objects.size(), 1U) << way;
    EXPECT_EQ(found.objects[0].area, 35) << way;
    ASSERT_EQ(found.holes.size(), 1U) << way;
    EXPECT_EQ(found.holes[0], (Region{11, 44, 37, 1, 3, 7, 4, 1})) << way;
  });
}

/// A spiral of dark lines one pixel wide with light between, closed by a frame.
ByteImage spiral(Index size) {
  ByteImage image(size, size);
  Index x = 0;
  Index y = 0;
  Index dx = 1;
  Index dy = 0;
  const auto dark_at = [&](Index at_x, Index at_y) {
    return at_x >= 0 && at_x < size && at_y >= 0 && at_y < size && image.at(at_x, at_y) != 0;
  };
  for (int turns = 0; turns < 2;) {
    image.at(x, y) = 255;
    const Index next_x = x + dx;
    const Index next_y = y + dy;
    const bool inside = next_x >= 0 && next_x < size && next_y >= 0 && next_y < size;
    if (inside && !dark_at(next_x, next_y) && !dark_at(next_x + dx, next_y + dy)) {
      x = next_x;
      y = next_y;
      turns = 0;
      continue;
    }
    const Index turned = -dy;
    dy = dx;
    dx = turned;
    ++turns;
  }
  return image;
}

TEST(Holes, spiral_is_one_object_and_one_hole_once_its_mouth_is_closed) {
  for (const Index size : {9, 64, 65, 129}) {
    ByteImage image = spiral(size);
    const Index light = size * size - reference::components(image.view()).objects[0].area;
    image.at(0, 1) = 255;  // the mouth is at the second row of the first column
    with_every_way(image.view(), [&](const Regions& found, const std::string& way) {
      ASSERT_EQ(found.objects.size(), 1U) << way << " at " << size;
      ASSERT_EQ(found.holes.size(), 1U) << way << " at " << size;
      EXPECT_EQ(found.holes[0].area, light - 1) << way << " at " << size;
    });
  }
}

TEST(Holes, wide_rows_and_tall_images_do_not_overflow_short_sums) {
  for (const auto& [width, height] :
       {std::pair<Index, Index>{20000, 60}, {65534, 5}, {70000, 4}, {9, 3000}}) {
    ByteImage image(width, height);
    for (Index y = 0; y < height; ++y) {
      for (Index x = 0; x < width; ++x) {
        const bool frame = x == 0 || y == 0 || x == width - 1 || y == height - 1;
        image.at(x, y) = frame || x == width / 2 ? 255 : 0;
      }
    }
    const reference::Regions expected = reference::holes(image.view());
    ASSERT_EQ(expected.holes.size(), 2U);
    with_every_way(image.view(),
                   [&, columns = width](const Regions& found, const std::string& way) {
                     EXPECT_EQ(found.objects, expected.objects) << way << " at " << columns;
                     EXPECT_EQ(found.holes, expected.holes) << way << " at " << columns;
                   });
  }
}

TEST(FillHoles, fills_what_an_object_encloses_with_all_that_lies_in_it) {
  const ByteImage image = picture({"#####..", "#...#.#", "#.#.#..", "#...#..", "#####.."});
  const ByteImage expected = picture({"#####..", "#####.#", "#####..", "#####..", "#####.."});
  ByteImage filled(image.width(), image.height());
  fill_holes(image.view(), filled.view());
  EXPECT_TRUE(equal(filled.view(), expected.view()));
  filled = copy_of(image.view());
  fill_holes(filled.view(), filled.view(), {Technique::union_find});
  EXPECT_TRUE(equal(filled.view(), expected.view())) << "in place";
}

}  // namespace
}  // namespace thinbench
