// localise_objects().
#include "thinbench/localise.hpp"

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/made_image.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

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
