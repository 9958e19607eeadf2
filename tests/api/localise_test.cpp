// localise_objects().
#include "thinbench/localise.hpp"

#include <cstdint>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "localise.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

TEST(LocaliseObjects, equals_the_reference_by_default) {
  const ByteImage blocks = grey_noise_image(40, 30, 0, 255, 3);
  ByteImage image(200, 150);
  for (Index y = 0; y < 150; ++y) {
    for (Index x = 0; x < 200; ++x) image.at(x, y) = blocks.at(x / 5, y / 5);
  }
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
  const ByteImage blocks = grey_noise_image(40, 30, 0, 255, 5);
  ByteImage image(203, 151);
  for (Index y = 0; y < 151; ++y) {
    for (Index x = 0; x < 203; ++x) image.at(x, y) = blocks.at(x / 6, y / 6);
  }
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

TEST(LocaliseObjects, rejects_an_image_of_another_size) {
  ByteImage image(10, 4), small(9, 4);
  EXPECT_EQ(rejection_of(
                [&] { (void)localise_objects(image.view(), small.view(), EdgeThresholds{}, {}); }),
            "source is 10 x 4 and destination 9 x 4; they must have the same size");
}

TEST(LocaliseObjects, finds_nothing_in_images_without_edges) {
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}, {7, 7}}) {
    const ByteImage image(width, height);
    EXPECT_TRUE(localise_objects(image.view()).objects.empty());
    EXPECT_TRUE(localise_objects(image.view(), {}, {.threads = 4}).holes.empty());
  }
}

std::string rejected(const ConstImageView& view, const EdgeThresholds& thresholds = {},
                     const Execution& execution = {}) {
  const std::string text =
      rejection_of([&] { (void)localise_objects(view, thresholds, execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  return text;
}

TEST(LocaliseObjects, rejects_invalid_views) {
  const ByteImage image(10, 4);
  const std::uint8_t* data = image.view().data;
  EXPECT_EQ(rejected({nullptr, 10, 4, 64}), "source has no data");
  EXPECT_EQ(rejected({data, 10, 4, 9}), "source has a stride of 9 bytes, below its width of 10");
  EXPECT_EQ(rejected({data, 10, -4, 64}), "source has the size 10 x -4");
  EXPECT_EQ(rejected({data, (Index{1} << 29) + 1, 0}),
            "image size 536870913 x 0 has a side above 2^29 pixels");
}

TEST(LocaliseObjects, rejects_unsuitable_thresholds_and_options) {
  const ByteImage image(10, 4);
  const ConstImageView view = image.view();
  EXPECT_EQ(rejected(view, {256, 0}),
            "gradient_threshold: expected an integer in [0, 255], got 256");
  EXPECT_EQ(rejected(view, {0, -1}),
            "brightness_threshold: expected an integer in [0, 255], got -1");
  EXPECT_EQ(rejected(view, {}, {.threads = 0}), "threads: expected an integer in [1, 1024], got 0");
}

}  // namespace
}  // namespace thinbench
