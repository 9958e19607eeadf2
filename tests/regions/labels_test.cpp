// Label images: every pixel has the label of its region.
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "holes.hpp"
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
  [[nodiscard]] bool beside_unwritten(Index y) const { return at(width_, y) == kUnwritten; }

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

/// The region of every label from 1 to `count`, from the label image.
std::vector<Region> summed(const Labels& labels, const ConstImageView& image, std::size_t count) {
  std::vector<Region> found(count, {0, 0, 0, INT32_MAX, INT32_MAX, -1, -1, 0});
  for (std::int32_t y = 0; y < image.height; ++y) {
    for (std::int32_t x = 0; x < image.width; ++x) {
      if (labels.at(x, y) == 0) continue;
      Region& region = found.at(static_cast<std::size_t>(labels.at(x, y) - 1));
      region.area += 1;
      region.sum_x += x;
      region.sum_y += y;
      region.left = std::min(region.left, x);
      region.right = std::max(region.right, x);
      region.top = std::min(region.top, y);
      region.bottom = std::max(region.bottom, y);
    }
  }
  return found;
}

/// Whether neighbours of one colour have the same label.
bool neighbours_agree(const Labels& labels, const ConstImageView& image, bool eight) {
  const auto agree = [&](Index x, Index y, Index x2, Index y2) {
    if (x2 < 0 || x2 >= image.width || y2 >= image.height) return true;
    const bool foreground = image.row(y)[x] != 0;
    if (!foreground || image.row(y2)[x2] == 0) return true;
    return labels.at(x, y) == labels.at(x2, y2);
  };
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) {
      if (!agree(x, y, x + 1, y) || !agree(x, y, x, y + 1)) return false;
      if (eight && (!agree(x, y, x + 1, y + 1) || !agree(x, y, x - 1, y + 1))) return false;
    }
  }
  return true;
}

bool labels_equal_the_lists(const ConstImageView& image) {
  Labels labels(image);
  const Regions found = label_regions(image, labels.view(image.height));
  const reference::Regions expected = reference::holes(image);
  if (found.objects != expected.objects || found.holes != expected.holes) return false;
  std::vector<Region> all = found.objects;
  all.insert(all.end(), found.holes.begin(), found.holes.end());
  std::vector<Region> from_labels = summed(labels, image, all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    from_labels[i].enclosing_object = all[i].enclosing_object;
  }
  for (Index y = 0; y < image.height; ++y) {
    if (!labels.beside_unwritten(y)) return false;
    for (Index x = 0; x < image.width; ++x) {
      const bool is_object =
          labels.at(x, y) > 0 && labels.at(x, y) <= static_cast<int>(found.objects.size());
      if (is_object != (image.row(y)[x] != 0)) return false;
    }
  }
  return from_labels == all && neighbours_agree(labels, image, true);
}

/// Whether the labels without a list are those with one.
bool image_equals(const Labels& expected, const ConstImageView& image, Connectivity connectivity,
                  std::size_t objects) {
  Labels labels(image);
  return label_image(image, labels.view(image.height), connectivity) == objects &&
         labels.equal(expected);
}

bool components_are_connected_as(const ConstImageView& image, Connectivity connectivity) {
  Labels labels(image);
  const auto found = label_components(image, labels.view(image.height), connectivity);
  const std::int64_t holes =
      static_cast<std::int64_t>(found.size()) -
      (connectivity == Connectivity::eight ? euler_number(image) : euler_number_4(image));
  return holes >= 0 && image_equals(labels, image, connectivity, found.size()) &&
         summed(labels, image, found.size()) == found &&
         neighbours_agree(labels, image, connectivity == Connectivity::eight);
}

TEST(Labels, equal_the_lists_on_all_images_of_4x4_pixels) {
  for (std::uint32_t bits = 0; bits < 65536; ++bits) {
    std::uint8_t pixels[16];
    for (int i = 0; i < 16; ++i) pixels[i] = static_cast<std::uint8_t>(bits >> i & 1);
    const ConstImageView image(pixels, 4, 4);
    ASSERT_TRUE(labels_equal_the_lists(image)) << bits;
    ASSERT_TRUE(components_are_connected_as(image, Connectivity::four)) << bits;
  }
}

TEST(Labels, equal_the_lists_on_noise_and_scenes) {
  for (const ByteImage& image : property_images()) {
    EXPECT_TRUE(labels_equal_the_lists(image.view()));
    EXPECT_TRUE(components_are_connected_as(image.view(), Connectivity::eight));
    EXPECT_TRUE(components_are_connected_as(image.view(), Connectivity::four));
  }
}

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
