#include "picture/objects.hpp"

#include <gtest/gtest.h>

namespace thinbench {
namespace {

ByteImage all_levels() {
  ByteImage image(256, 1);
  for (Index x = 0; x < 256; ++x) image.at(x, 0) = static_cast<std::uint8_t>(x);
  return image;
}

TEST(Objects, are_pixels_at_or_above_the_threshold) {
  const ByteImage image = objects_of(all_levels(), 60);
  for (Index x = 0; x < 256; ++x) EXPECT_EQ(image.at(x, 0), x >= 60 ? 255 : 0) << x;
  EXPECT_EQ(object_pixels(image.view()), 196);
}

TEST(Objects, are_the_other_pixels_where_inverted) {
  const ByteImage image = objects_of(all_levels(), 60, true);
  for (Index x = 0; x < 256; ++x) EXPECT_EQ(image.at(x, 0), x < 60 ? 255 : 0) << x;
  EXPECT_EQ(object_pixels(image.view()), 60);
}

TEST(Objects, threshold_is_128_where_none_is_given) {
  EXPECT_EQ(object_pixels(objects_of(all_levels()).view()), 128);
}

TEST(ObjectPixels, counts_the_view_and_not_what_lies_between_its_rows) {
  const std::uint8_t bytes[] = {1, 0, 9, 0, 255, 9};
  EXPECT_EQ(object_pixels({bytes, 2, 2, 3}), 2);
}

}  // namespace
}  // namespace thinbench
