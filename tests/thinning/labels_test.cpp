// thin_labels(): equal to the reference on each label alone; borders, strides, rejected arguments.
#include "thinbench/labels.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "compile/rule_body.hpp"
#include "harness/test_images.hpp"
#include "support/reference_thinning.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"

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

ByteImage mask_of(LabelImage& image, std::int32_t label) {
  ByteImage mask(image.width, image.height);
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) mask.at(x, y) = image.at(x, y) == label ? 255 : 0;
  }
  return mask;
}

/// Thins the labels one after another; returns the maximum number of iterations.
int thin_each_by_reference(const Rule& rule, LabelImage& image, LabelImage& result,
                           const reference::Repetition& repetition) {
  std::set<std::int32_t> labels(image.labels.begin(), image.labels.end());
  labels.erase(kUntouched);
  for (Index y = 0; y < image.height; ++y) std::fill_n(result.view().row(y), image.width, 0);
  int iterations = 0;
  for (const std::int32_t label : labels) {
    if (label == 0) continue;
    const Thinned thinned = thinned_by_reference(rule, mask_of(image, label), repetition);
    iterations = std::max(iterations, thinned.iterations);
    for (Index y = 0; y < image.height; ++y) {
      for (Index x = 0; x < image.width; ++x) {
        if (thinned.image.at(x, y) != 0) result.at(x, y) = label;
      }
    }
  }
  return iterations;
}

/// Compares with the reference, on one thread and on three, into another image and in place.
void expect_reference(const Rule& rule, LabelImage image, const reference::Repetition& repetition) {
  LabelImage expected = {image.width, image.height};
  const int iterations = thin_each_by_reference(rule, image, expected, repetition);
  for (const int threads : {1, 3}) {
    const Thinning thinning = {repetition.border, repetition.max_iterations};
    const Execution execution = {.threads = threads};
    LabelImage result = {image.width, image.height};
    EXPECT_EQ(thin_labels(rule, image.view(), result.view(), thinning, execution), iterations);
    EXPECT_EQ(result.labels, expected.labels) << image.width << " wide, threads " << threads;
    LabelImage in_place = image;
    EXPECT_EQ(thin_labels(rule, in_place.view(), in_place.view(), thinning, execution), iterations);
    EXPECT_EQ(in_place.labels, expected.labels) << image.width << " wide, in place";
  }
}

/// Those that add no pixels, without foreground outside.
std::vector<RuleAndBorder> rules_for_labels() {
  std::vector<RuleAndBorder> all = rules_and_borders();
  std::erase_if(all, [](const RuleAndBorder& one) {
    return one.border == Border::foreground || one.rule.body()->adds_pixels();
  });
  return all;
}

class ThinLabels : public testing::TestWithParam<RuleAndBorder> {};

TEST_P(ThinLabels, equals_the_reference_on_each_label_alone) {
  const auto& [name, rule, border] = GetParam();
  for (const Index width : {1, 2, 30, 33, 62, 64, 65, 129, 150}) {
    expect_reference(rule, noise_labels(width, 37, 85, 16, 12), {.border = border});
    expect_reference(rule, noise_labels(width, 9, 95, 140, 9), {.border = border});
  }
  expect_reference(rule, noise_labels(140, 140, 97, 200, 60), {.border = border});
  expect_reference(rule, noise_labels(60, 50, 90, 20, 20), {border, 2});
}

INSTANTIATE_TEST_SUITE_P(All, ThinLabels, testing::ValuesIn(rules_for_labels()),
                         rule_and_border_test_name);

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

TEST(ThinLabels, takes_no_iteration_without_labels) {
  LabelImage image = {50, 4};
  std::fill(image.labels.begin(), image.labels.end(), 0);
  EXPECT_EQ(thin_labels(Rule::guo_hall, image.view(), image.view()), 0);
  for (const auto& [width, height] : {std::pair<Index, Index>{0, 0}, {0, 5}, {5, 0}}) {
    EXPECT_EQ(thin_labels(Rule::mb2, {nullptr, width, height}, {nullptr, width, height}), 0);
  }
}

/// The error for these arguments; checks that nothing was written.
std::string rejected(const ConstLabelView& source, const LabelView& destination,
                     const Thinning& thinning = {}, const Execution& execution = {}) {
  const std::string text =
      rejection_of([&] { thin_labels(Rule::guo_hall, source, destination, thinning, execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  return text;
}

TEST(ThinLabels, rejects_invalid_arguments_and_writes_nothing) {
  LabelImage image = noise_labels(40, 20, 90, 10, 10);
  LabelImage result = {40, 20};
  const std::int32_t* data = image.labels.data();
  EXPECT_EQ(rejected({data, -1, 20}, result.view()), "image size -1 x 20 is negative");
  EXPECT_EQ(rejected({data, 1 << 16, 1 << 16}, result.view()),
            "image size 65536 x 65536 is larger than 2^31 pixels, the limit for labels");
  EXPECT_EQ(rejected({data, 39, 20, 43}, result.view()),
            "source is 39 x 20 and destination 40 x 20; they must have the same size");
  EXPECT_EQ(rejected({nullptr, 40, 20}, result.view()), "source has no data");
  EXPECT_EQ(rejected({data, 40, 20, 39}, result.view()),
            "source has a stride of 156 bytes, below its width of 160");
  EXPECT_EQ(rejected({data, 40, 20, PTRDIFF_MAX / 3}, result.view()),
            "source exceeds the address space: 40 x 20, stride 3074457345618258602");
  EXPECT_EQ(rejected({result.labels.data() + 1, 40, 19, 43}, {result.labels.data(), 40, 19, 43}),
            "source and destination overlap without being the same image");
  EXPECT_EQ(rejected(image.view(), result.view(), {}, {.threads = 0}),
            "threads: expected an integer in [1, 1024], got 0");
  EXPECT_EQ(rejected(image.view(), result.view(), {.max_iterations = 0}),
            "max_iterations: expected an integer of at least 1, got 0");
  image.at(7, 19) = -3;
  EXPECT_EQ(rejected(image.view(), result.view(), {}, {.threads = 2}),
            "labels: expected 0 or more, got -3 in row 19, column 7");
  EXPECT_TRUE(std::all_of(result.labels.begin(), result.labels.end(),
                          [](std::int32_t label) { return label == kUntouched; }));
}

TEST(ThinLabels, rejects_rules_that_add_pixels_and_foreground_outside) {
  LabelImage image = noise_labels(40, 20, 90, 10, 10);
  LabelImage result = {40, 20};
  for (const auto& [name, rule, border] : rules_and_borders()) {
    if (border != Border::foreground && !rule.body()->adds_pixels()) continue;
    const Rule& tested = rule;
    const Thinning thinning = {border};
    const std::string text =
        rejection_of([&] { thin_labels(tested, image.view(), result.view(), thinning); });
    EXPECT_TRUE(is_one_sentence(text)) << name << ": " << text;
  }
  const Rule life = Rule::named("life");
  EXPECT_EQ(rejection_of([&] { thin_labels(life, image.view(), result.view()); }),
            "life adds pixels, which would belong to no label; apply it to an image");
  EXPECT_EQ(rejection_of([&] {
              thin_labels(Rule::guo_hall, image.view(), result.view(), {Border::foreground});
            }),
            "guo_hall: labels have no border of foreground");
  EXPECT_TRUE(std::all_of(result.labels.begin(), result.labels.end(),
                          [](std::int32_t label) { return label == kUntouched; }));
}

TEST(ThinLabels, strides_too_small_for_a_count_of_bytes_are_rejected) {
  constexpr Index smallest = std::numeric_limits<Index>::min();
  std::int32_t label = 7;
  const std::string exceeds = " exceeds the address space: ";
  EXPECT_EQ(rejection_of([&] {
              thin_labels(Rule::guo_hall, {&label, 0, 1, smallest}, {&label, 0, 1, 1});
            }),
            "source" + exceeds + "0 x 1, stride " + std::to_string(smallest));
  EXPECT_EQ(rejection_of([&] {
              thin_labels(Rule::guo_hall, {&label, 0, 1, 1}, {&label, 0, 1, smallest});
            }),
            "destination" + exceeds + "0 x 1, stride " + std::to_string(smallest));
}

}  // namespace
}  // namespace thinbench
