// The references on hand-worked images: objects and holes, and the relabelling scan as published,
// with its count of holes and when that count is wrong.
#include <stdexcept>

#include <gtest/gtest.h>

#include "holes.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

TEST(Holes, of_plates_are_numbered_by_their_first_pixels_and_have_areas_centres_and_boxes) {
  const ByteImage image =
      image_of({".........###", ".#######.#.#", ".#.##..#.###", ".####..#....",  //
                ".#######...."});
  const reference::Regions found = reference::holes(image.view());
  ASSERT_EQ(found.objects.size(), 2U);
  EXPECT_EQ(found.objects[1], (Region{23, 88, 58, 1, 1, 7, 4, 0}));
  ASSERT_EQ(found.holes.size(), 3U);
  EXPECT_EQ(found.holes[0], (Region{1, 10, 1, 10, 1, 10, 1, 1}));
  EXPECT_EQ(found.holes[1], (Region{1, 2, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(found.holes[2], (Region{4, 22, 10, 5, 2, 6, 3, 2}));
  EXPECT_EQ(found.holes[2].centre_x(), 5.5);
  EXPECT_EQ(found.holes[2].centre_y(), 2.5);
}

struct Scanned {
  ByteImage levels;
  reference::LiteralHoles count;
};

Scanned scan(const ByteImage& contours) {
  Scanned scanned{ByteImage(contours.width(), contours.height()), {}};
  scanned.count = reference::holes_literal(contours.view(), scanned.levels.view());
  return scanned;
}

int holes_of_object(const ByteImage& image) {
  ByteImage contours(image.width(), image.height());
  reference::contours_of(image.view(), contours.view());
  return scan(contours).count.holes();
}

TEST(HolesLiteral, example_of_the_paper_with_flag_252_has_two_holes) {
  const ByteImage contours = image_of(
      {"###########", "#.........#", "#.##...##.#", "#.##...##.#", "#.........#", "###########"});
  const Scanned scanned = scan(contours);
  EXPECT_EQ(scanned.count.flag, 252);
  EXPECT_EQ(scanned.count.holes(), 2);
  EXPECT_EQ(scanned.levels.at(0, 5), 254) << "the exterior contour";
  EXPECT_EQ(scanned.levels.at(3, 3), 253);
  EXPECT_EQ(scanned.levels.at(8, 3), 252);
}

TEST(HolesLiteral, merged_branches_release_their_levels) {
  // Three branches (254, 253, 252) merge below; the dot gets the next free level.
  const ByteImage contours = image_of({"#.#.#..", "#.#.#..", "#####.#"});
  const Scanned scanned = scan(contours);
  EXPECT_EQ(scanned.count.flag, 253);
  EXPECT_EQ(scanned.levels.at(2, 0), 254);
  EXPECT_EQ(scanned.levels.at(4, 0), 254);
  EXPECT_EQ(scanned.levels.at(6, 2), 253);
}

TEST(HolesLiteral, released_level_raises_all_lower_levels) {
  // 254: left branch; 253: right branch; 252: dot. The branches merge, and the dot becomes 253.
  const ByteImage contours = image_of({"#.#.#", "#.#..", "##..."});
  const Scanned scanned = scan(contours);
  EXPECT_EQ(scanned.levels.at(4, 0), 253);
  EXPECT_EQ(scanned.count.flag, 253);
}

/// Isolated foreground pixels in a row.
ByteImage dots(Index count) {
  ByteImage image(2 * count, 3);
  for (Index i = 0; i < count; ++i) image.at(2 * i, 1) = 255;
  return image;
}

TEST(HolesLiteral, more_than_254_levels_are_rejected) {
  EXPECT_EQ(scan(dots(254)).count.flag, 1);
  EXPECT_THROW((void)scan(dots(255)), std::length_error);
}

/// A plate with a row of one-pixel holes, `wall` pixels from its border and from each other.
ByteImage plate_with_holes(Index holes, Index wall) {
  const Index width = holes * (wall + 1) + wall;
  return image_by(width, 2 * wall + 1, [=](Index x, Index y) {
    return y == wall && x % (wall + 1) == wall && x < width - 1 ? 0 : 255;
  });
}

TEST(HolesLiteral, is_correct_on_one_object_whose_walls_are_at_least_three_pixels_thick) {
  for (const Index holes : {0, 1, 2, 7, 40}) {
    for (const Index wall : {3, 4, 9}) {
      const ByteImage image = plate_with_holes(holes, wall);
      ASSERT_EQ(reference::holes(image.view()).holes.size(), static_cast<std::size_t>(holes));
      EXPECT_EQ(holes_of_object(image), holes) << wall;
    }
  }
}

TEST(HolesLiteral, counts_every_object_after_the_first_as_a_hole) {
  const ByteImage two = image_of({"###.###", "#.#.###", "###.###"});
  EXPECT_EQ(reference::holes(two.view()).holes.size(), 1U);
  EXPECT_EQ(holes_of_object(two), 1)
      << "the second object; the hole has the same contour as its object";
}

TEST(HolesLiteral, misses_holes_behind_walls_of_one_or_two_pixels) {
  for (const Index wall : {1, 2}) {
    EXPECT_EQ(reference::holes(plate_with_holes(5, wall).view()).holes.size(), 5U);
    EXPECT_EQ(holes_of_object(plate_with_holes(5, wall)), 0) << "inner and outer contours touch";
  }
}

}  // namespace
}  // namespace thinbench
