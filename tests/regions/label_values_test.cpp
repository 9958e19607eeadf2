// Components of equal values.
#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "holes.hpp"
#include "support/made_image.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

using Values = std::vector<std::int32_t>;

/// By the reference of labels, a value after the other, renumbered in raster order.
Values expected(const ByteImage& image, int background, bool eight) {
  Values labels(static_cast<std::size_t>(image.width() * image.height()), 0);
  const auto label = eight ? reference::label_components : reference::label_components_4;
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
      ASSERT_EQ(labels, expected(image, background, connectivity == Connectivity::eight));
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

}  // namespace
}  // namespace thinbench
