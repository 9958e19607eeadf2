// localise_objects().
#include "thinbench/localise.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "localise.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

/// Squares of any level.
ByteImage blocks(Index width, Index height, std::uint64_t seed) {
  const ByteImage levels = grey_noise_image(41, 31, 0, 255, seed);
  return image_by(width, height, [&](Index x, Index y) { return levels.at(x / 5, y / 5); });
}

TEST(LocaliseObjects, equals_the_reference_by_default) {
  const ByteImage image = blocks(200, 150, 3);
  const EdgeThresholds thresholds = {60, 100};
  const reference::Regions expected =
      reference::localise_objects(reference::edges(EdgeOperator::sobel), thresholds, image.view());
  ASSERT_FALSE(expected.holes.empty());
  for (const int threads : {1, 3}) {
    const Regions found = localise_objects(image.view(), thresholds, {.threads = threads});
    EXPECT_EQ(found.objects, expected.objects);
    EXPECT_EQ(found.holes, expected.holes);
  }
}

TEST(LocaliseObjects, are_the_regions_of_the_image_that_is_written) {
  ByteImage image = blocks(203, 151, 5);
  const EdgeThresholds thresholds = {60, 100};
  const Regions expected = localise_objects(image.view(), thresholds);
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    ByteImage objects(203, 151);
    const Regions found = localise_objects(image.view(), objects.view(), thresholds, {.isa = isa});
    const Regions drawn = find_regions(objects.view());
    EXPECT_EQ(found.objects, expected.objects);
    EXPECT_EQ(drawn.objects, expected.objects);
    EXPECT_EQ(drawn.holes, expected.holes);
  }
  const Regions in_place = localise_objects(image.view(), image.view(), thresholds, {});
  EXPECT_EQ(in_place.holes, find_regions(image.view()).holes);
}

TEST(LocaliseObjects, finds_nothing_in_images_without_edges) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}, {7, 7}}) {
    const ByteImage image(width, height);
    EXPECT_TRUE(localise_objects(image.view()).objects.empty());
    EXPECT_TRUE(localise_objects(image.view(), {}, {.threads = 4}).holes.empty());
  }
}

}  // namespace
}  // namespace thinbench
