// thin_many(): equal to the reference on each image; aliasing, strides, rejected arguments.
#include "thinbench/many.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/reference_thinning.hpp"
#include "support/rule_parameters.hpp"
#include "support/untouched.hpp"
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
    const ImageView view = image.view();
    iterations = std::max(iterations, thin_by_reference(rule, repetition, view, view));
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

TEST(ThinMany, equals_the_reference_on_more_images_of_one_size_than_the_cache_holds) {
  ImageList list;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    list.images.emplace_back(noise_image(120, 120, 85, 3, seed), 0);
  }
  expect_reference(Rule::guo_hall, list, {});
}

TEST(ThinMany, takes_no_iteration_without_images_and_one_for_images_without_pixels) {
  EXPECT_EQ(thin_many(Rule::guo_hall, {}, {}), 0);
  const ConstImageView source[] = {{nullptr, 0, 5}, {nullptr, 5, 0}};
  const ImageView destination[] = {{nullptr, 0, 5}, {nullptr, 5, 0}};
  EXPECT_EQ(thin_many(Rule::mb2, source, destination), 1);
}

TEST(ThinMany, shares_the_rows_of_large_images_among_threads) {
  const ByteImage image = noise_image(1100, 1000, 90, 3, 8);
  ByteImage expected(1100, 1000), result(1100, 1000);
  const int iterations = thin(Rule::guo_hall, image.view(), expected.view());
  const ConstImageView source[] = {image.view()};
  const ImageView destination[] = {result.view()};
  EXPECT_EQ(thin_many(Rule::guo_hall, source, destination, {}, {.threads = 3}), iterations);
  EXPECT_TRUE(equal(result.view(), expected.view()));
}

TEST(ThinMany, equals_thin_on_large_images_more_and_fewer_than_threads) {
  ImageList images, expected;
  int iterations = 0;
  for (const Index width : {1100, 1050, 300, 1200, 1100, 1101}) {
    images.images.emplace_back(noise_image(width, 1000, 90, 3, 8), 3);
    expected.images.push_back(images.images.back());
    const ImageView view = expected.images.back().view();
    iterations = std::max(iterations, thin(Rule::mb2, view, view));
  }
  for (const int threads : {2, 3, 5, 7}) {
    ImageList result = images;
    EXPECT_EQ(thin_many(Rule::mb2, result.const_views(), result.views(), {}, {.threads = threads}),
              iterations);
    EXPECT_TRUE(result.images == expected.images) << threads;
  }
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

/// A call must fail without a byte written.
void expect_many_rejected(std::vector<ConstImageView> sources, std::vector<ImageView> destinations,
                          const std::string& part, const Thinning& thinning = {},
                          const Execution& execution = {}) {
  expect_rejected([&] { thin_many(Rule::guo_hall, sources, destinations, thinning, execution); },
                  part);
}

TEST(ThinMany, rejects_invalid_images_and_options_and_writes_nothing) {
  std::vector<std::uint8_t> from(1600, 1), to(1600, kUntouched);
  const ConstImageView good = part(from, 0, 0, 9, 9);
  const ImageView good_to = part(to, 0, 0, 9, 9);
  expect_many_rejected({good, good}, {good_to}, "got 2 sources and 1 destinations");
  auto* const far = reinterpret_cast<std::uint8_t*>(std::uintptr_t{1} << 60);
  constexpr Index side = Index{1} << 21;
  struct Case {
    ConstImageView source;
    ImageView destination;
    std::string part;
  };
  const Case cases[] = {
      {{from.data(), -1, 5}, part(to, 0, 20, 5, 5), "source has the size -1 x 5"},
      {{from.data(), 5, 5}, {nullptr, 5, 5}, "destination has no data"},
      {{from.data(), 5, 5, 4}, part(to, 0, 20, 5, 5), "source has a stride of 4 bytes, below its"},
      {{from.data(), 5, 5}, part(to, 0, 20, 5, 6), "source is 5 x 5 and destination 5 x 6; they"},
      {{from.data(), side, side / 2}, {far, side, side / 2}, "is larger than 2^40 pixels"}};
  for (const auto& [source, destination, part] : cases) {
    expect_many_rejected({good, source}, {good_to, destination}, "image 1: ");
    expect_many_rejected({good, source}, {good_to, destination}, part);
  }
  expect_many_rejected({good}, {good_to}, "threads: expected", {}, {.threads = 0});
  expect_many_rejected({good}, {good_to}, "max_iterations: expected", {.max_iterations = 0});
  expect_many_rejected({}, {}, "border: expected", {.border = static_cast<Border>(3)});
  EXPECT_EQ(to, std::vector<std::uint8_t>(1600, kUntouched));
}

TEST(ThinMany, rejects_destinations_that_share_bytes_with_another_image) {
  std::vector<std::uint8_t> from(1600, 1), to(1600, kUntouched);
  const ConstImageView other = part(from, 0, 0, 9, 9);
  const ImageView first = part(to, 0, 0, 9, 9);
  const ConstImageView inner = part(to, 5, 5, 9, 9);
  const std::string both = "the destination of image 1 shares bytes with the destination of image ";
  expect_many_rejected({other, other}, {first, part(to, 8, 8, 9, 9)}, both + "0");
  expect_many_rejected({other, other}, {first, first}, both + "0");
  expect_many_rejected({other, inner}, {first, part(to, 9, 9, 9, 9)},
                       "image 1: source and destination overlap without being the same image");
  expect_many_rejected({other, inner}, {first, part(to, 20, 20, 9, 9)},
                       "the destination of image 0 shares bytes with the source of image 1");
  EXPECT_EQ(to, std::vector<std::uint8_t>(1600, kUntouched));
}

}  // namespace
}  // namespace thinbench
