// thin_labels(): borders, strides, rejected arguments. The operations labels_... of the cross-check
// compare each label alone with the reference.
#include "thinbench/labels.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "compile/rule_body.hpp"
#include "harness/test_images.hpp"
#include "support/rule_parameters.hpp"
#include "support/untouched.hpp"

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

TEST(ThinLabels, rejects_invalid_arguments_and_writes_nothing) {
  constexpr Index smallest = std::numeric_limits<Index>::min();
  LabelImage image = noise_labels(40, 20, 90, 10, 10);
  LabelImage result = {40, 20};
  std::int32_t* const data = image.labels.data();
  std::int32_t* const out = result.labels.data();
  const auto expect_labels_rejected = [](const ConstLabelView& source, const LabelView& destination,
                                         const std::string& part, const Thinning& thinning = {},
                                         const Execution& execution = {}) {
    expect_rejected([&] { thin_labels(Rule::guo_hall, source, destination, thinning, execution); },
                    part);
  };
  struct Case {
    ConstLabelView source;
    LabelView destination;
    std::string part;
  };
  const Case cases[] = {
      {{data, -1, 20}, result.view(), "image size -1 x 20 is negative"},
      {{data, 1 << 16, 1 << 16}, result.view(), "image size 65536 x 65536 is larger than 2^31"},
      {{data, 39, 20, 43}, result.view(), "source is 39 x 20 and destination 40 x 20; they must"},
      {{nullptr, 40, 20}, result.view(), "source has no data"},
      {{data, 40, 20, 39}, result.view(), "source has a stride of 39, below its width of 40"},
      {{data, 40, 20, PTRDIFF_MAX / 3}, result.view(), "source exceeds the address space: 40 x 20"},
      {{data, 0, 1, smallest},
       {data, 0, 1, 1},
       "source has a stride of -9223372036854775808, below"},
      {{data, 0, 1, 1}, {data, 0, 1, smallest}, "destination has a stride of -9223372036854775808"},
      {{out + 1, 40, 19, 43}, {out, 40, 19, 43}, "overlap without being the same image"}};
  for (const auto& [source, destination, part] : cases) {
    expect_labels_rejected(source, destination, part);
  }
  expect_labels_rejected(image.view(), result.view(), "threads: expected", {}, {.threads = 0});
  expect_labels_rejected(image.view(), result.view(), "got 0", {.max_iterations = 0});
  image.at(7, 19) = -3;
  expect_labels_rejected(image.view(), result.view(),
                         "labels: expected 0 or more, got -3 in row 19, column 7");
  EXPECT_EQ(result.labels, (LabelImage{40, 20}.labels));
}

TEST(ThinLabels, rejects_rules_that_add_pixels_and_foreground_outside) {
  LabelImage image = noise_labels(40, 20, 90, 10, 10);
  LabelImage result = {40, 20};
  const auto expect_rule_rejected = [&](const Rule& rule, Border border, const char* part) {
    expect_rejected([&] { thin_labels(rule, image.view(), result.view(), {border}); }, part);
  };
  for (const auto& [name, rule, border] : rules_and_borders()) {
    if (border != Border::foreground && !detail::body_of(rule)->adds_pixels()) continue;
    expect_rule_rejected(rule, border, "");
  }
  expect_rule_rejected(Rule::named("life"), Border::background,
                       "life adds pixels, which would belong to no label; apply it to an image");
  expect_rule_rejected(Rule::guo_hall, Border::foreground,
                       "border: expected background or keep for labels, got foreground");
  EXPECT_EQ(result.labels, (LabelImage{40, 20}.labels));
}

}  // namespace
}  // namespace thinbench
