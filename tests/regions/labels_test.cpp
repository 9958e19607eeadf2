// Label images: the order of OpenCV, and what is rejected. Crosscheck compares all else with the
// references.
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/property_images.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

/// Labels with a value beside each row that must not be written.
class Labels {
 public:
  explicit Labels(const ConstImageView& image)
      : width_(image.width),
        values_(static_cast<std::size_t>((image.width + 1) * image.height), kUnwritten) {}

  [[nodiscard]] LabelView view(Index height) {
    return {values_.data(), width_, height, width_ + 1};
  }
  [[nodiscard]] std::int32_t at(Index x, Index y) const {
    return values_[static_cast<std::size_t>(y * (width_ + 1) + x)];
  }
  [[nodiscard]] bool equal(const Labels& other) const { return values_ == other.values_; }

  /// Whether no pixel has been written.
  [[nodiscard]] bool unwritten() const {
    return values_ == std::vector<std::int32_t>(values_.size(), kUnwritten);
  }

 private:
  static constexpr std::int32_t kUnwritten = -7;
  Index width_;
  std::vector<std::int32_t> values_;
};

/// The labels that the blocks of 2 x 2 pixels find first, from the labels in raster order.
std::vector<std::int32_t> numbers_by_blocks(const Labels& labels, const ConstImageView& image,
                                            std::size_t objects) {
  std::vector<std::int32_t> numbers(objects + 1);
  std::int32_t next = 0;
  for (Index y = 0; y < image.height; y += 2) {
    for (Index x = 0; x < image.width; x += 2) {
      for (Index i = 0; i < 4; ++i) {
        if (x + i % 2 >= image.width || y + i / 2 >= image.height) continue;
        const std::int32_t label = labels.at(x + i % 2, y + i / 2);
        if (label != 0 && numbers[static_cast<std::size_t>(label)] == 0) {
          numbers[static_cast<std::size_t>(label)] = ++next;
        }
      }
    }
  }
  return numbers;
}

bool opencv_order_is_that_of_blocks(const ConstImageView& image, const Execution& execution) {
  Labels raster(image), blocks(image);
  const auto objects = label_components(image, raster.view(image.height), Connectivity::eight);
  const auto found = label_components(image, blocks.view(image.height), Connectivity::eight,
                                      execution, LabelOrder::opencv);
  const auto numbers = numbers_by_blocks(raster, image, objects.size());
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) {
      if (blocks.at(x, y) != numbers[static_cast<std::size_t>(raster.at(x, y))]) return false;
    }
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
    Labels raster(image.view()), ordered(image.view());
    const LabelView view = ordered.view(image.height());
    label_image(image.view(), raster.view(image.height()), Connectivity::four);
    label_image(image.view(), view, Connectivity::four, {}, LabelOrder::opencv);
    EXPECT_TRUE(ordered.equal(raster));
  }
}

TEST(Labels, of_images_without_pixels_are_empty) {
  EXPECT_TRUE(label_regions({nullptr, 0, 5}, {nullptr, 0, 5}).objects.empty());
  EXPECT_TRUE(label_components({nullptr, 5, 0}, {nullptr, 5, 0}, Connectivity::four).empty());
}

TEST(Labels, reject_sizes_that_differ_overlaps_and_other_connectivities) {
  const ByteImage image(8, 8);
  Labels labels(image.view());
  const LabelView view = labels.view(8);
  EXPECT_THROW(label_regions(image.view(), {view.data, 7, 8, 9}), std::invalid_argument);
  EXPECT_THROW(label_regions(image.view(), {view.data, 8, 8, 7}), std::invalid_argument);
  EXPECT_THROW(label_regions(image.view(), {nullptr, 8, 8}), std::invalid_argument);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(view.data);
  EXPECT_THROW(label_regions({bytes, 8, 8}, view), std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(label_components(image.view(), view, static_cast<Connectivity>(6))),
      std::invalid_argument);
  EXPECT_THROW(static_cast<void>(label_image(image.view(), view, static_cast<Connectivity>(6))),
               std::invalid_argument);
  EXPECT_TRUE(labels.unwritten());
}

}  // namespace
}  // namespace thinbench
