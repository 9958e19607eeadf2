// Label images: the order of OpenCV, components of equal values, and holes that are filled.
// Crosscheck compares all else with the references.
#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "holes.hpp"
#include "support/made_image.hpp"
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

/// Wider than the sums of 16 bits; narrower than a cache line, but large enough for non-temporal
/// stores.
TEST(Labels, of_images_of_extreme_shapes_equal_the_reference) {
  for (const ByteImage& image : {noise_image(65535, 3, 50, 1, 2), noise_image(70001, 4, 70, 3, 5),
                                 noise_image(9, 120000, 40, 1, 7)}) {
    LabelImage expected = unwritten(image.view());
    const reference::Regions regions = reference::label_regions(image.view(), expected.view());
    for (const Isa isa : all_isas()) {
      if (!isa_available(isa)) continue;
      for (const int threads : {1, 2}) {
        LabelImage found = unwritten(image.view());
        const Execution execution = {.threads = threads, .isa = isa};
        const Regions lists = label_regions(image.view(), found.view(), execution);
        EXPECT_TRUE(lists.objects == regions.objects && lists.holes == regions.holes);
        EXPECT_TRUE(found.labels == expected.labels) << image.width();
        EXPECT_TRUE(find_regions(image.view(), execution).holes == regions.holes);
      }
    }
  }
}

TEST(Labels, of_images_without_pixels_are_empty) {
  EXPECT_TRUE(label_regions({nullptr, 0, 5}, {nullptr, 0, 5}).objects.empty());
  EXPECT_TRUE(label_objects({nullptr, 5, 0}, {nullptr, 5, 0}, Connectivity::four).empty());
}

using Values = std::vector<std::int32_t>;

/// By the reference of labels, a value after the other, renumbered in raster order.
Values labels_by_reference(const ByteImage& image, int background, bool eight) {
  Values labels(static_cast<std::size_t>(image.width() * image.height()), 0);
  const auto label = eight ? reference::label_objects : reference::label_objects_4;
  std::int32_t others = 0;  // the number of components of the values before
  for (int value = 0; value < 8; ++value) {
    if (value == background) continue;
    const ByteImage mask = mapped(image, [=](int pixel) { return pixel == value ? 255 : 0; });
    Values of_value(labels.size());
    const auto found = label(mask.view(), {of_value.data(), image.width(), image.height()});
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (of_value[i] != 0) labels[i] = others + of_value[i];
    }
    others += static_cast<std::int32_t>(found.size());
  }
  std::map<std::int32_t, std::int32_t> numbers = {{0, 0}};
  for (std::int32_t& number : labels) {
    const auto next = static_cast<std::int32_t>(numbers.size());
    number = numbers.try_emplace(number, next).first->second;
  }
  return labels;
}

TEST(LabelValues, equals_the_reference_of_each_value) {
  std::mt19937 random(1);
  for (int i = 0; i < 400; ++i) {
    const Index width = 1 + static_cast<Index>(random() % 20);
    const Index height = 1 + static_cast<Index>(random() % 20);
    const auto values_in_all = static_cast<unsigned>(2 + i % 5);
    const ByteImage image =
        image_by(width, height, [&](Index, Index) { return random() % values_in_all; });
    Values values;
    for (Index y = 0; y < height; ++y) {
      values.insert(values.end(), image.view().row(y), image.view().row(y) + width);
    }
    const int background = i % 3;
    for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
      Values labels(values.size(), -7);
      const std::uint32_t count = label_values(
          {values.data(), width, height}, {labels.data(), width, height}, connectivity, background);
      ASSERT_EQ(labels,
                labels_by_reference(image, background, connectivity == Connectivity::eight));
      ASSERT_EQ(count, static_cast<std::uint32_t>(*std::ranges::max_element(labels)));
    }
  }
}

TEST(LabelValues, takes_any_value_and_stride) {
  const Values values = {INT32_MIN, INT32_MAX, 9, INT32_MIN, -1, 9};
  Values labels(8, -7);
  EXPECT_EQ(
      label_values({values.data(), 2, 2, 3}, {labels.data(), 2, 2, 4}, Connectivity::eight, -1),
      2U);
  EXPECT_EQ(labels, (Values{1, 2, -7, -7, 1, 0, -7, -7}));
}

TextImage filled(const TextImage& lines, Connectivity connectivity = Connectivity::eight,
                 std::int64_t max_area = kAnyHoleArea) {
  LabelImage image = labels_of(lines);
  fill_holes_of_labels(image.view(), image.view(), {connectivity, max_area});
  TextImage result;
  for (Index y = 0; y < image.height; ++y) {
    std::string line;
    for (Index x = 0; x < image.width; ++x) {
      const int label = image.view().row(y)[x];
      line += label == 0 ? '.' : static_cast<char>('0' + label);
    }
    result.push_back(line);
  }
  return result;
}

/// Outlines of rectangles, drawn over each other, with some pixels removed.
LabelImage random_rings(std::mt19937& random) {
  const auto below = [&](Index end) {
    return static_cast<Index>(random() % static_cast<unsigned>(end));
  };
  LabelImage image = {20 + below(60), 20 + below(20), {}};
  image.labels.resize(static_cast<std::size_t>(image.width * image.height));
  for (int i = 0; i < 14; ++i) {
    const Index left = below(image.width), top = below(image.height);
    const Index right = left + below(image.width - left), bottom = top + below(image.height - top);
    const auto label = static_cast<std::int32_t>(1 + below(4));
    for (Index y = top; y <= bottom; ++y) {
      for (Index x = left; x <= right; ++x) {
        const bool is_outline = x == left || x == right || y == top || y == bottom;
        if (is_outline) image.view().row(y)[x] = label;
      }
    }
  }
  for (int i = 0; i < 3; ++i) image.view().row(below(image.height))[below(image.width)] = 0;
  return image;
}

void expect_as_reference(const LabelImage& image, Connectivity connectivity,
                         std::int64_t max_area) {
  LabelImage expected = image;
  reference::fill_label_holes(image.view(), expected.view(), connectivity == Connectivity::four,
                              max_area);
  LabelImage found = image;
  fill_holes_of_labels(image.view(), found.view(), {connectivity, max_area});
  EXPECT_EQ(found.labels, expected.labels);
  found = image;
  fill_holes_of_labels(found.view(), found.view(), {connectivity, max_area});
  EXPECT_EQ(found.labels, expected.labels) << "in place";
}

TEST(FillHolesOfLabels, equals_the_reference) {
  std::mt19937 random(34);
  for (int i = 0; i < 300; ++i) {
    const LabelImage image = i % 2 == 0 ? random_labels(random) : random_rings(random);
    for (const Connectivity connectivity : {Connectivity::eight, Connectivity::four}) {
      for (const std::int64_t area :
           {kAnyHoleArea, std::int64_t{0}, std::int64_t{2}, std::int64_t{30}}) {
        expect_as_reference(image, connectivity, area);
      }
    }
  }
}

TEST(FillHolesOfLabels, of_images_worked_by_hand_are_those_of_the_innermost_label_around_them) {
  const std::pair<TextImage, TextImage> images[] = {
      {{"111222", "1.12.2", "111222"}, {"111222", "111222", "111222"}},
      {{"1122", "1..2", "1122"}, {"1122", "1..2", "1122"}},
      {{"333333", "3....3", "3.12.3", "31..23", "3.12.3", "3....3", "333333"},
       {"333333", "333333", "331233", "313323", "331233", "333333", "333333"}},
      {{"1111111", "1.....1", "1.222.1", "1.2.2.1", "1.222.1", "1.....1", "1111111"},
       {"1111111", "1111111", "1122211", "1122211", "1122211", "1111111", "1111111"}},
      {{"22222", "21112", "21.12", "21112", "22222"},
       {"22222", "21112", "21112", "21112", "22222"}},
      {{"1111", "1231", "1.31", "1111"}, {"1111", "1231", "1131", "1111"}}};
  for (const auto& [image, expected] : images) EXPECT_EQ(filled(image), expected);
}

TEST(FillHolesOfLabels, depends_on_the_connectivity_of_labels) {
  const TextImage diamond = {".1.", "1.1", ".1."};
  EXPECT_EQ(filled(diamond), (TextImage{".1.", "111", ".1."}));
  EXPECT_EQ(filled(diamond, Connectivity::four), diamond);
}

TEST(FillHolesOfLabels, fills_holes_up_to_an_area_of_background) {
  const TextImage image = {"1111111", "1.2.1.1", "1111111"};
  EXPECT_EQ(filled(image, Connectivity::eight, 1), (TextImage{"1111111", "1.2.111", "1111111"}))
      << "a hole that another label cuts in two has two pixels";
  EXPECT_EQ(filled(image, Connectivity::eight, 2), (TextImage{"1111111", "1121111", "1111111"}));
  EXPECT_EQ(filled(image, Connectivity::eight, 0), image);
}

TEST(FillHolesOfLabels, takes_strides_and_images_without_pixels) {
  const LabelImage image = labels_of({"1111", "1.1.", "1111"});
  std::vector<std::int32_t> out(15, -7);
  fill_holes_of_labels({image.labels.data(), 3, 3, 4}, {out.data(), 3, 3, 5});
  EXPECT_EQ(out[6], 1);
  EXPECT_EQ(std::count(out.begin(), out.end(), -7), 6);
  fill_holes_of_labels({nullptr, 5, 0}, {nullptr, 5, 0});
  fill_holes_of_labels({nullptr, 0, 5}, {nullptr, 0, 5});
}

}  // namespace
}  // namespace thinbench
