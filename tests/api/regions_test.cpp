// fill_holes(), the Euler numbers and localise_objects().
#include "thinbench/regions.hpp"

#include <array>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "thinbench/localise.hpp"

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

TEST(LocaliseObjects, are_the_regions_of_the_image_that_is_written) {
  const ByteImage levels = grey_noise_image(41, 31, 0, 255, 5);
  ByteImage image = image_by(203, 151, [&](Index x, Index y) { return levels.at(x / 5, y / 5); });
  const EdgeThresholds thresholds = {60, 100};
  const Regions expected = localise_objects(image.view(), thresholds);
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    ByteImage objects(203, 151);
    const Regions found = localise_objects(image.view(), thresholds, {.isa = isa}, objects.view());
    const Regions drawn = find_regions(objects.view());
    EXPECT_EQ(found.objects, expected.objects);
    EXPECT_EQ(drawn.objects, expected.objects);
    EXPECT_EQ(drawn.holes, expected.holes);
  }
  const Regions in_place = localise_objects(image.view(), thresholds, {}, image.view());
  EXPECT_EQ(in_place.holes, find_regions(image.view()).holes);
}

}  // namespace
}  // namespace thinbench
