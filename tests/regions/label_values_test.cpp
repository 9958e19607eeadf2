// Components of equal values.
#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/byte_image.hpp"
#include "support/flood_fill.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

using detail::ByteImage;
using Values = std::vector<std::int32_t>;

ByteImage random_values(Index width, Index height, int values, std::mt19937& random) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      image.view().row(y)[x] = static_cast<std::uint8_t>(random() % static_cast<unsigned>(values));
    }
  }
  return image;
}

/// By flood fills, a value after the other, renumbered in raster order.
Values expected(const ConstImageView& image, int background, bool eight) {
  Values labels(static_cast<std::size_t>(image.width * image.height), 0);
  std::vector<Index> firsts;
  for (int value = 0; value < 256; ++value) {
    if (value == background) continue;
    const auto found = flood_fill::FloodFill(image, value, eight).take();
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (found.label[i] == 0) continue;
      labels[i] =
          static_cast<std::int32_t>(found.list[static_cast<std::size_t>(found.label[i] - 1)].first);
    }
    for (const auto& component : found.list) firsts.push_back(component.first);
  }
  std::ranges::sort(firsts);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (image.row(static_cast<Index>(i) / image.width)[static_cast<Index>(i) % image.width] ==
        background) {
      continue;
    }
    const auto place = std::ranges::lower_bound(firsts, Index{labels[i]});
    labels[i] = static_cast<std::int32_t>(place - firsts.begin()) + 1;
  }
  return labels;
}

TEST(LabelValues, equals_flood_fills_of_every_value) {
  std::mt19937 random(1);
  for (int i = 0; i < 400; ++i) {
    const Index width = 1 + static_cast<Index>(random() % 20);
    const Index height = 1 + static_cast<Index>(random() % 20);
    const ByteImage image = random_values(width, height, 2 + i % 5, random);
    Values values;
    for (Index y = 0; y < height; ++y) {
      values.insert(values.end(), image.view().row(y), image.view().row(y) + width);
    }
    const int background = i % 3;
    for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
      Values labels(values.size(), -7);
      const std::uint32_t count = label_values(
          {values.data(), width, height}, {labels.data(), width, height}, connectivity, background);
      ASSERT_EQ(labels, expected(image.view(), background, connectivity == Connectivity::eight));
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

TEST(LabelValues, rejects_other_connectivities_and_images_that_share_bytes) {
  Values values(6, 1);
  const LabelView view(values.data(), 3, 2);
  Values labels(6);
  EXPECT_THROW(label_values(view, view, Connectivity::eight), std::invalid_argument);
  EXPECT_THROW(label_values(view, {labels.data(), 2, 2}, Connectivity::eight),
               std::invalid_argument);
  EXPECT_THROW(label_values(view, {labels.data(), 3, 2}, Connectivity{6}), std::invalid_argument);
}

}  // namespace
}  // namespace thinbench
