// The public edge: what is refused, and what a plan keeps.
#include <stdexcept>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "holes/pictures.hpp"

namespace thinbench {
namespace {

TEST(FindHoles, refuses_bad_views_and_wishes) {
  const ByteImage image(10, 4);
  ConstByteView view = image.view();
  EXPECT_THROW((void)find_holes({nullptr, 10, 4, 64}), std::invalid_argument);
  EXPECT_THROW((void)find_holes({view.data, -1, 4, 64}), std::invalid_argument);
  EXPECT_THROW((void)find_holes({view.data, 10, 4, 9}), std::invalid_argument);
  EXPECT_THROW((void)find_holes(view, {Technique::kLut}), std::invalid_argument);
  EXPECT_THROW((void)find_holes(view, {{}, {}, 0}), std::invalid_argument);
  EXPECT_THROW((void)euler_number(view, {{}, {}, 2}), std::invalid_argument);
  ByteImage other(11, 4);
  EXPECT_THROW(fill_holes(view, other.view()), std::invalid_argument);
}

TEST(FindHoles, has_nothing_to_say_of_images_without_pixels) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    const ByteImage image(width, height);
    EXPECT_TRUE(find_holes(image.view()).objects.empty());
    EXPECT_TRUE(find_holes(image.view(), {{}, {}, 4}).holes.empty());
    EXPECT_EQ(euler_number(image.view()), 0);
  }
}

TEST(HolesPlan, refuses_sizes_beyond_its_numbers) {
  const HolesOperation& operation = *find_holes_operation("holes");
  const HolesVariant& variant = operation.variants.front();
  EXPECT_THROW(HolesPlan(operation, variant, kMaxHolesSide + 1, 1), std::invalid_argument);
  EXPECT_THROW(HolesPlan(operation, variant, 1 << 17, 1 << 17), std::invalid_argument);
  EXPECT_THROW(HolesPlan(operation, variant, -1, 1), std::invalid_argument);
  EXPECT_THROW(HolesPlan(operation, variant, 1, 1, 1025), std::invalid_argument);
}

TEST(HolesPlan, gives_the_same_after_an_image_with_many_more_regions) {
  const ByteImage simple = noise_image(300, 200, 50, 20, 3);
  const ByteImage crowded = noise_image(300, 200, 50, 1, 4);
  const reference::Regions expected = reference::holes(simple.view());
  const HolesOperation& operation = *find_holes_operation("holes");
  for (const HolesVariant& variant : operation.variants) {
    if (!why_unavailable(facts_of(variant), 300).empty()) continue;
    HolesPlan plan(operation, variant, 300, 200, variant.threaded ? 4 : 1);
    for (const ByteImage* image : {&simple, &crowded, &simple}) plan.run(image->view());
    const RegionLists found = plan.regions();
    EXPECT_TRUE(std::equal(found.holes.begin(), found.holes.end(), expected.holes.begin(),
                           expected.holes.end()));
    EXPECT_TRUE(std::equal(found.objects.begin(), found.objects.end(), expected.objects.begin(),
                           expected.objects.end()));
  }
}

}  // namespace
}  // namespace thinbench
