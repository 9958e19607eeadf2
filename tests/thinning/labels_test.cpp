// thin_labels(): borders and strides. The operations labels_... of the cross-check
// compare each label alone with the reference.
#include "thinbench/labels.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"

namespace thinbench {
namespace {

constexpr std::int32_t kUntouched = 0x5A5A5A5A;

/// Owns labels, with a gap after each row.
struct LabelImage {
  Index width, height;
  std::vector<std::int32_t> labels =
      std::vector<std::int32_t>(static_cast<std::size_t>((width + 3) * height), kUntouched);

  [[nodiscard]] LabelView view() { return {labels.data(), width, height, width + 3}; }
  [[nodiscard]] std::int32_t& at(Index x, Index y) { return view().row(y)[x]; }
};

/// Noise, cut into blocks of block_width x block_height pixels with sparse labels that recur.
LabelImage noise_labels(Index width, Index height, int percent, Index block_width,
                        Index block_height) {
  constexpr std::int32_t values[] = {
      7, std::numeric_limits<std::int32_t>::max(), 1, 70'000, 2, 123'456'789};
  const ByteImage noise = noise_image(width, height, percent, 3, 11);
  LabelImage image = {width, height};
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      const auto block = x / block_width + 2 * (y / block_height);
      image.at(x, y) = noise.at(x, y) != 0 ? values[block % 6] : 0;
    }
  }
  return image;
}

TEST(ThinLabels, keeps_the_image_border_and_no_other) {
  LabelImage image = {20, 12};
  for (Index y = 0; y < 12; ++y) {
    for (Index x = 0; x < 20; ++x) image.at(x, y) = x < 10 ? 1 : 2;
  }
  LabelImage result = {20, 12};
  thin_labels(Rule::guo_hall, image.view(), result.view(), {.border = Border::keep});
  for (Index x = 0; x < 20; ++x) EXPECT_EQ(result.at(x, 0), image.at(x, 0)) << x;
  for (Index y = 0; y < 12; ++y) EXPECT_EQ(result.at(0, y), 1) << y;
  EXPECT_EQ(result.at(9, 6), 0) << "the border between the labels is thinned";
  EXPECT_EQ(result.at(10, 6), 0);
}

/// A run must not be taken for a part of the one that ends the row above.
TEST(ThinLabels, needs_no_gap_between_rows) {
  LabelImage image = noise_labels(24, 37, 85, 140, 9);
  std::vector<std::int32_t> labels;
  for (Index y = 0; y < image.height; ++y) {
    labels.insert(labels.end(), image.view().row(y), image.view().row(y) + image.width);
  }
  const LabelView dense = {labels.data(), image.width, image.height, image.width};
  thin_labels(Rule::guo_hall, dense, dense);
  thin_labels(Rule::guo_hall, image.view(), image.view());
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x)
      ASSERT_EQ(dense.row(y)[x], image.at(x, y)) << x << ", " << y;
  }
}

TEST(ThinLabels, writes_to_another_image_what_it_writes_in_place) {
  for (const Index width : {1, 30, 65, 150}) {
    for (const int threads : {1, 3}) {
      LabelImage image = noise_labels(width, 37, 85, 16, 12);
      LabelImage result = {width, 37};
      const int iterations =
          thin_labels(Rule::mb2, image.view(), result.view(), {}, {.threads = threads});
      EXPECT_EQ(thin_labels(Rule::mb2, image.view(), image.view()), iterations);
      EXPECT_EQ(result.labels, image.labels) << width << " wide, threads " << threads;
    }
  }
}

TEST(ThinLabels, takes_no_iteration_without_labels) {
  LabelImage image = {50, 4};
  std::fill(image.labels.begin(), image.labels.end(), 0);
  EXPECT_EQ(thin_labels(Rule::guo_hall, image.view(), image.view()), 0);
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    EXPECT_EQ(thin_labels(Rule::mb2, {nullptr, width, height}, {nullptr, width, height}), 0);
  }
}

}  // namespace
}  // namespace thinbench
