// thin_many(): equal to the reference on each image; aliasing, strides, rejected arguments.
#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/reference_thinning.hpp"
#include "support/rejection.hpp"
#include "support/rule_parameters.hpp"
#include "thinbench/batch.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kUntouched = 0x5A;

/// Owns an image, with a gap after each row.
struct GappedImage {
  Index width, height, gap;
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t>(static_cast<std::size_t>((width + gap) * height), kUntouched);

  explicit GappedImage(const ByteImage& image, Index row_gap)
      : width(image.width()), height(image.height()), gap(row_gap) {
    for (Index y = 0; y < height; ++y) std::copy_n(image.view().row(y), width, view().row(y));
  }
  GappedImage(Index columns, Index rows, Index row_gap)
      : width(columns), height(rows), gap(row_gap) {}

  [[nodiscard]] ImageView view() { return {bytes.data(), width, height, width + gap}; }
  friend bool operator==(const GappedImage&, const GappedImage&) = default;
};

/// Images and the views of a call.
struct ImageList {
  std::deque<GappedImage> images;

  [[nodiscard]] std::vector<ImageView> views() {
    std::vector<ImageView> all;
    for (GappedImage& image : images) all.push_back(image.view());
    return all;
  }
  [[nodiscard]] std::vector<ConstImageView> const_views() {
    const std::vector<ImageView> all = views();
    return {all.begin(), all.end()};
  }
};

/// Noise of many sizes, each several times, in no order; every third image has gaps.
ImageList noise_of_many_sizes() {
  ImageList list;
  std::uint64_t seed = 0;
  for (int round = 0; round < 3; ++round) {
    for (const Index width : {28, 1, 150, 33, 7, 64, 65, 128, 129, 0, 20}) {
      for (const Index height : {28, 1, 33, 140, 9, 0}) {
        const Index gap = seed % 3 == 0 ? 5 : 0;
        list.images.emplace_back(noise_image(width, height, 85, 3, ++seed), gap);
      }
    }
  }
  for (int i = 0; i < 40; ++i) list.images.emplace_back(noise_image(28, 28, 80, 3, ++seed), 0);
  return list;
}

/// Thins the images one by one; returns the maximum number of iterations.
int thin_each_by_reference(const Rule& rule, ImageList& list,
                           const reference::Repetition& repetition) {
  int iterations = 0;
  for (GappedImage& image : list.images) {
    ByteImage source(image.width, image.height);
    for (Index y = 0; y < image.height; ++y) {
      std::copy_n(image.view().row(y), image.width, source.view().row(y));
    }
    const Thinned thinned = thinned_by_reference(rule, source, repetition);
    iterations = std::max(iterations, thinned.iterations);
    for (Index y = 0; y < image.height; ++y) {
      std::copy_n(thinned.image.view().row(y), image.width, image.view().row(y));
    }
  }
  return iterations;
}

void expect_reference(const Rule& rule, const ImageList& images,
                      const reference::Repetition& repetition) {
  ImageList expected = images;
  const int iterations = thin_each_by_reference(rule, expected, repetition);
  for (const int threads : {1, 3}) {
    const Thinning thinning = {repetition.border, repetition.max_iterations};
    const Execution execution = {.threads = threads};
    ImageList source = images;
    ImageList result;
    for (const GappedImage& image : images.images) {
      result.images.emplace_back(image.width, image.height, image.gap);
    }
    EXPECT_EQ(thin_many(rule, source.const_views(), result.views(), thinning, execution),
              iterations);
    EXPECT_TRUE(source.images == images.images);
    EXPECT_TRUE(result.images == expected.images) << "threads " << threads;
    EXPECT_EQ(thin_many(rule, source.const_views(), source.views(), thinning, execution),
              iterations);
    EXPECT_TRUE(source.images == expected.images) << "in place, threads " << threads;
  }
}

class ThinMany : public testing::TestWithParam<RuleAndBorder> {};

TEST_P(ThinMany, equals_the_reference_on_each_image) {
  const auto& [name, rule, border] = GetParam();
  expect_reference(rule, noise_of_many_sizes(), {.border = border});
  expect_reference(rule, noise_of_many_sizes(), {border, 2});
}

INSTANTIATE_TEST_SUITE_P(All, ThinMany, all_rules_and_borders(), rule_and_border_test_name);

/// Their pixels must not spread over what is drawn beside an image.
TEST(ThinMany, equals_the_reference_by_rules_that_add_and_remove_pixels) {
  for (const char* name : {"life", "majority", "bridge"}) {
    for (const Border border : {Border::background, Border::keep, Border::foreground}) {
      expect_reference(Rule::named(name), noise_of_many_sizes(), {border, 3});
    }
  }
}

TEST(ThinMany, takes_no_iteration_without_images_and_one_for_images_without_pixels) {
  EXPECT_EQ(thin_many(Rule::guo_hall, {}, {}), 0);
  const ConstImageView source[] = {{nullptr, 0, 5}, {nullptr, 5, 0}};
  const ImageView destination[] = {{nullptr, 0, 5}, {nullptr, 5, 0}};
  EXPECT_EQ(thin_many(Rule::mb2, source, destination), 1);
}

TEST(ThinMany, shares_the_rows_of_large_images_among_threads) {
  const ByteImage image = noise_image(1100, 1000, 90, 3, 8);
  ByteImage expected(1100, 1000);
  ByteImage result(1100, 1000);
  const int iterations = thin(Rule::guo_hall, image.view(), expected.view());
  const ConstImageView source[] = {image.view()};
  const ImageView destination[] = {result.view()};
  EXPECT_EQ(thin_many(Rule::guo_hall, source, destination, {}, {.threads = 3}), iterations);
  EXPECT_TRUE(equal(result.view(), expected.view()));
}

/// A view of part of a 40 x 40 image.
ImageView part(std::vector<std::uint8_t>& bytes, Index x, Index y, Index width, Index height) {
  return {bytes.data() + y * 40 + x, width, height, 40};
}

TEST(ThinMany, takes_images_side_by_side_in_one_buffer_and_sources_that_overlap) {
  const ByteImage noise = noise_image(40, 40, 85, 3, 9);
  std::vector<std::uint8_t> from(noise.view().data, noise.view().data + 1600);
  std::vector<std::uint8_t> to(1600, kUntouched);
  const ConstImageView source[] = {part(from, 3, 5, 20, 20), part(from, 8, 9, 20, 20),
                                   part(from, 3, 5, 20, 20)};
  const ImageView destination[] = {part(to, 0, 0, 20, 20), part(to, 20, 0, 20, 20),
                                   part(to, 5, 20, 20, 20)};
  thin_many(Rule::guo_hall, source, destination);
  std::vector<std::uint8_t> expected(1600, kUntouched);
  for (int i = 0; i < 3; ++i) {
    const ImageView& view = destination[i];
    thin(Rule::guo_hall, source[i], {expected.data() + (view.data - to.data()), 20, 20, 40});
  }
  EXPECT_EQ(to, expected);
}

TEST(ThinMany, thins_halves_of_an_image_in_place) {
  const ByteImage noise = noise_image(40, 40, 85, 3, 9);
  std::vector<std::uint8_t> pixels(noise.view().data, noise.view().data + 1600);
  std::vector<std::uint8_t> expected = pixels;
  const ImageView halves[] = {part(pixels, 0, 0, 20, 40), part(pixels, 20, 0, 20, 40)};
  const std::vector<ConstImageView> sources(std::begin(halves), std::end(halves));
  thin_many(Rule::guo_hall, sources, halves);
  for (const Index x : {0, 20}) {
    const ImageView half = part(expected, x, 0, 20, 40);
    thin(Rule::guo_hall, half, half);
  }
  EXPECT_EQ(pixels, expected);
}

/// The error for these images; checks that nothing was written.
std::string rejected(std::vector<std::uint8_t>& to, std::vector<ConstImageView> sources,
                     std::vector<ImageView> destinations, const Thinning& thinning = {},
                     const Execution& execution = {}) {
  const std::string text =
      rejection_of([&] { thin_many(Rule::guo_hall, sources, destinations, thinning, execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  EXPECT_TRUE(
      std::all_of(to.begin(), to.end(), [](std::uint8_t byte) { return byte == kUntouched; }));
  return text;
}

TEST(ThinMany, rejects_invalid_images_and_options_and_writes_nothing) {
  std::vector<std::uint8_t> from(1600, 1);
  std::vector<std::uint8_t> to(1600, kUntouched);
  const ConstImageView good = part(from, 0, 0, 9, 9);
  const ImageView good_to = part(to, 0, 0, 9, 9);
  const auto second = [&](const ConstImageView& source, const ImageView& destination) {
    return rejected(to, {good, source}, {good_to, destination});
  };
  EXPECT_EQ(rejected(to, {good, good}, {good_to}),
            "expected as many destinations as sources, got 2 sources and 1 destinations");
  EXPECT_EQ(second({from.data(), -1, 5}, part(to, 0, 20, 5, 5)),
            "image 1: source has the size -1 x 5");
  EXPECT_EQ(second({from.data(), 5, 5}, {nullptr, 5, 5}), "image 1: destination has no data");
  EXPECT_EQ(second({from.data(), 5, 5, 4}, part(to, 0, 20, 5, 5)),
            "image 1: source has a stride of 4 bytes, below its width of 5");
  EXPECT_EQ(second({from.data(), 5, 5}, part(to, 0, 20, 5, 6)),
            "image 1: source is 5 x 5 and destination 5 x 6; they must have the same size");
  auto* const far = reinterpret_cast<std::uint8_t*>(std::uintptr_t{1} << 60);
  EXPECT_EQ(
      second({from.data(), Index{1} << 21, Index{1} << 20}, {far, Index{1} << 21, Index{1} << 20}),
      "image 1: image size 2097152 x 1048576 is larger than 2^40 pixels");
  EXPECT_EQ(rejected(to, {good}, {good_to}, {}, {.threads = 0}),
            "threads: expected an integer in [1, 1024], got 0");
  EXPECT_EQ(rejected(to, {good}, {good_to}, {.max_iterations = 0}),
            "max_iterations: expected an integer of at least 1, got 0");
  EXPECT_EQ(rejected(to, {}, {}, {.border = static_cast<Border>(3)}),
            "border: expected background, keep or foreground, got 3");
}

TEST(ThinMany, rejects_destinations_that_share_bytes_with_another_image) {
  std::vector<std::uint8_t> from(1600, 1);
  std::vector<std::uint8_t> to(1600, kUntouched);
  const ConstImageView other = part(from, 0, 0, 9, 9);
  EXPECT_EQ(rejected(to, {other, other}, {part(to, 0, 0, 9, 9), part(to, 8, 8, 9, 9)}),
            "the destination of image 1 shares bytes with the destination of image 0");
  EXPECT_EQ(
      rejected(to, {other, part(to, 5, 5, 9, 9)}, {part(to, 0, 0, 9, 9), part(to, 9, 9, 9, 9)}),
      "image 1: source and destination overlap without being the same image");
  EXPECT_EQ(
      rejected(to, {other, part(to, 5, 5, 9, 9)}, {part(to, 0, 0, 9, 9), part(to, 20, 20, 9, 9)}),
      "the destination of image 0 shares bytes with the source of image 1");
  EXPECT_EQ(rejected(to, {other, other}, {part(to, 0, 0, 9, 9), part(to, 0, 0, 9, 9)}),
            "the destination of image 1 shares bytes with the destination of image 0");
}

}  // namespace
}  // namespace thinbench
