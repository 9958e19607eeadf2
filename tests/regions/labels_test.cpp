// Label images: the order of OpenCV. Crosscheck compares all else with the references.
#include <vector>

#include <gtest/gtest.h>

#include "support/label_image.hpp"
#include "support/property_images.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

constexpr std::int32_t kUnwritten = -7;

LabelImage unwritten(const ConstImageView& image) {
  const auto pixels = static_cast<std::size_t>(image.width * image.height);
  return {image.width, image.height, std::vector<std::int32_t>(pixels, kUnwritten)};
}

/// The labels that the blocks of 2 x 2 pixels find first, from the labels in raster order.
std::vector<std::int32_t> numbers_by_blocks(const ConstLabelView& labels, std::size_t objects) {
  std::vector<std::int32_t> numbers(objects + 1);
  std::int32_t next = 0;
  for (Index y = 0; y < labels.height; y += 2) {
    for (Index x = 0; x < labels.width; x += 2) {
      for (Index i = 0; i < 4; ++i) {
        if (x + i % 2 >= labels.width || y + i / 2 >= labels.height) continue;
        const std::int32_t label = labels.row(y + i / 2)[x + i % 2];
        if (label != 0 && numbers[static_cast<std::size_t>(label)] == 0) {
          numbers[static_cast<std::size_t>(label)] = ++next;
        }
      }
    }
  }
  return numbers;
}

bool opencv_order_is_that_of_blocks(const ConstImageView& image, const Execution& execution) {
  LabelImage raster = unwritten(image), blocks = unwritten(image);
  const auto objects = label_objects(image, raster.view(), Connectivity::eight);
  const auto found =
      label_objects(image, blocks.view(), Connectivity::eight, LabelOrder::opencv, execution);
  const auto numbers = numbers_by_blocks(raster.view(), objects.size());
  for (std::size_t i = 0; i < blocks.labels.size(); ++i) {
    if (blocks.labels[i] != numbers[static_cast<std::size_t>(raster.labels[i])]) return false;
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (found[static_cast<std::size_t>(numbers[i + 1] - 1)] != objects[i]) return false;
  }
  return found.size() == objects.size();
}

TEST(Labels, in_the_order_of_opencv_are_numbered_by_blocks) {
  for (std::uint32_t bits = 0; bits < 65536; ++bits) {
    std::uint8_t pixels[16];
    for (int i = 0; i < 16; ++i) pixels[i] = static_cast<std::uint8_t>(bits >> i & 1);
    ASSERT_TRUE(opencv_order_is_that_of_blocks({pixels, 4, 4}, {})) << bits;
  }
  for (const ByteImage& image : property_images()) {
    for (const Isa isa : all_isas()) {
      if (!isa_available(isa)) continue;
      EXPECT_TRUE(opencv_order_is_that_of_blocks(image.view(), {.isa = isa}));
    }
    LabelImage raster = unwritten(image.view()), ordered = unwritten(image.view());
    label_image(image.view(), raster.view(), Connectivity::four);
    label_image(image.view(), ordered.view(), Connectivity::four, LabelOrder::opencv);
    EXPECT_EQ(ordered.labels, raster.labels);
  }
}

TEST(Labels, of_images_without_pixels_are_empty) {
  EXPECT_TRUE(label_regions({nullptr, 0, 5}, {nullptr, 0, 5}).objects.empty());
  EXPECT_TRUE(label_objects({nullptr, 5, 0}, {nullptr, 5, 0}, Connectivity::four).empty());
}

}  // namespace
}  // namespace thinbench
