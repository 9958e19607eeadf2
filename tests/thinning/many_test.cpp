// Lists and stacks of images equal thin() of each image. The operations list_... of the cross-check
// compare lists with the references, engines/rules_test.cpp every rule in lanes.
#include "thinbench/many.hpp"

#include <algorithm>
#include <deque>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/rule_parameters.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kUntouched = 0x5A;

/// Owns an image, with a gap after each row.
struct GappedImage {
  Index width, height, gap;
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t>(static_cast<std::size_t>((width + gap) * height), kUntouched);

  [[nodiscard]] ImageView view() { return {bytes.data(), width, height, width + gap}; }
  friend bool operator==(const GappedImage&, const GappedImage&) = default;
};

/// Images and the views of a call.
struct ImageList {
  std::deque<GappedImage> images;

  void add(const ByteImage& image, Index gap) {
    GappedImage& added = images.emplace_back(GappedImage{image.width(), image.height(), gap});
    for (Index y = 0; y < added.height; ++y) {
      std::copy_n(image.view().row(y), added.width, added.view().row(y));
    }
  }
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

void expect_as_each(const Rule& rule, const Thinning& thinning, const ImageList& images,
                    const std::vector<int>& thread_counts) {
  ImageList expected = images;
  int iterations = 0;
  for (const ImageView& view : expected.views()) {
    iterations = std::max(iterations, thin(rule, view, view, thinning));
  }
  for (const int threads : thread_counts) {
    const Execution execution = {.threads = threads};
    ImageList source = images, result;
    for (const auto& [width, height, gap, bytes] : images.images) {
      result.images.emplace_back(GappedImage{width, height, gap});
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

/// Images of many sizes, each several times, in no order; every third has gaps.
TEST(ThinMany, equals_thin_on_each_image_by_rules_that_remove_and_add_pixels) {
  ImageList list;
  std::uint64_t seed = 0;
  for (int round = 0; round < 3; ++round) {
    for (const Index width : {28, 1, 150, 33, 7, 64, 65, 128, 129, 0, 20}) {
      for (const Index height : {28, 1, 33, 140, 9, 0}) {
        ++seed;
        list.add(noise_image(width, height, 85, 3, seed), seed % 3 == 0 ? 5 : 0);
      }
    }
  }
  for (int i = 0; i < 40; ++i) list.add(noise_image(28, 28, 80, 3, ++seed), 0);
  std::vector<RuleAndBorder> rules = rules_and_borders();
  for (const char* name : {"life", "majority", "bridge"}) {
    add_with_borders(name, Rule::named(name), rules);
  }
  for (const auto& [name, rule, border] : rules) {
    SCOPED_TRACE(name);
    expect_as_each(rule, {border, 3}, list, {1, 3});
  }
}

TEST(ThinMany, equals_thin_on_more_images_of_one_size_than_the_cache_holds) {
  ImageList list;
  for (std::uint64_t seed = 0; seed < 40; ++seed) list.add(noise_image(120, 120, 85, 3, seed), 0);
  expect_as_each(Rule::guo_hall, {}, list, {1, 3});
}

TEST(ThinMany, equals_thin_on_large_images_more_and_fewer_than_threads) {
  ImageList list;
  for (const Index width : {1100, 1050, 300, 1200, 1100, 1101}) {
    list.add(noise_image(width, 1000, 90, 3, 8), 3);
  }
  expect_as_each(Rule::mb2, {}, list, {2, 3, 5, 7});
}

TEST(ThinMany, takes_no_iteration_without_images_and_one_for_images_without_pixels) {
  EXPECT_EQ(thin_many(Rule::guo_hall, {}, {}), 0);
  const ConstImageView source[] = {{nullptr, 0, 5}, {nullptr, 5, 0}};
  const ImageView destination[] = {{nullptr, 0, 5}, {nullptr, 5, 0}};
  EXPECT_EQ(thin_many(Rule::mb2, source, destination), 1);
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

/// Images with gaps between rows and between images.
struct Stack {
  Index count, width, height;
  std::vector<std::uint8_t> bytes =
      std::vector<std::uint8_t>(static_cast<std::size_t>(count * (height * (width + 3) + 5)), 0x5A);

  [[nodiscard]] StackView view() {
    return {bytes.data(), count, width, height, width + 3, height * (width + 3) + 5};
  }
};

/// Noise whose foreground has any value but 0.
Stack noise_stack(Index count, Index width, Index height) {
  const ByteImage noise = noise_image(width, height * count, 80, 2, 4);
  Stack stack = {count, width, height};
  for (Index y = 0; y < noise.height(); ++y) {
    std::uint8_t* const row = stack.view().image(y / height).row(y % height);
    for (Index x = 0; x < width; ++x) {
      row[x] = noise.at(x, y) == 0 ? 0 : static_cast<std::uint8_t>(1 + (7 * x + y) % 255);
    }
  }
  return stack;
}

/// Thins each image alone and in place, which leaves gaps; returns the maximum of iterations.
int thin_each(const Rule& rule, Stack& stack) {
  int iterations = 0;
  for (Index i = 0; i < stack.count; ++i) {
    const ImageView image = stack.view().image(i);
    iterations = std::max(iterations, thin(rule, image, image));
  }
  return iterations;
}

void expect_as_each(const Rule& rule, const Stack& stack, int threads) {
  Stack expected = stack, in_place = stack, result = {stack.count, stack.width, stack.height};
  const int iterations = thin_each(rule, expected);
  EXPECT_EQ(thin_stack(rule, in_place.view(), result.view(), {}, {.threads = threads}), iterations);
  EXPECT_TRUE(result.bytes == expected.bytes) << stack.width << " wide, threads " << threads;
  EXPECT_EQ(thin_stack(rule, in_place.view(), in_place.view(), {}, {.threads = threads}),
            iterations);
  EXPECT_TRUE(in_place.bytes == expected.bytes) << stack.width << " wide, threads " << threads;
}

TEST(StackThinner, equals_thin_of_each_image_with_and_without_lanes_on_any_number_of_threads) {
  for (const Index width : {1, 28, 64, 128, 140}) {
    for (const int threads : {1, 2, 3, 7}) {
      expect_as_each(Rule::guo_hall, noise_stack(100, width, 12), threads);
      expect_as_each(Rule::mb2, noise_stack(37, width, 20), threads);
    }
  }
}

TEST(StackThinner, thins_large_images_on_a_thread_each_and_the_last_ones_on_all) {
  const Stack stack = noise_stack(3, 1100, 1000);
  for (const int threads : {1, 2, 3, 4}) expect_as_each(Rule::guo_hall, stack, threads);
}

TEST(StackThinner, takes_a_different_number_of_images_in_each_call) {
  StackThinner thinner(Rule::guo_hall, 28, 28, {}, {.threads = 2});
  StackThinner large_thinner(Rule::guo_hall, 1100, 1000, {}, {.threads = 2});
  const auto thins = [](StackThinner& by, Stack stack) {
    Stack expected = stack;
    EXPECT_EQ(by(stack.view(), stack.view()), thin_each(Rule::guo_hall, expected));
    EXPECT_TRUE(stack.bytes == expected.bytes) << stack.count << " of width " << stack.width;
  };
  for (const Index count : {3, 40, 0, 17, 1000}) thins(thinner, noise_stack(count, 28, 28));
  for (const Index count : {1, 3, 1, 2}) thins(large_thinner, noise_stack(count, 1100, 1000));
}

TEST(StackThinner, takes_no_iteration_for_an_empty_stack_and_one_for_images_without_pixels) {
  EXPECT_EQ(thin_stack(Rule::guo_hall, ConstStackView{}, StackView{}), 0);
  EXPECT_EQ(thin_stack(Rule::guo_hall, {nullptr, 0, 28, 28}, {nullptr, 0, 28, 28}), 0);
  EXPECT_EQ(thin_stack(Rule::guo_hall, {nullptr, 3, 0, 28}, {nullptr, 3, 0, 28}), 1);
  EXPECT_EQ(thin_stack(Rule::mb2, {nullptr, 3, 28, 0}, {nullptr, 3, 28, 0}), 1);
}

TEST(StackThinner, works_after_a_move) {
  static_assert(!std::is_copy_constructible_v<StackThinner>);
  static_assert(std::is_nothrow_move_constructible_v<StackThinner>);
  static_assert(std::is_nothrow_move_assignable_v<StackThinner>);
  Stack stack = noise_stack(2, 28, 28), expected = stack;
  StackThinner first(Rule::zhang_suen, 28, 28);
  StackThinner second(std::move(first));
  first = StackThinner(Rule::mb2, 5, 5);
  EXPECT_EQ(second(stack.view(), stack.view()), thin_each(Rule::zhang_suen, expected));
  EXPECT_TRUE(stack.bytes == expected.bytes);
}

}  // namespace
}  // namespace thinbench
