// Stacks of images equal thin() of each image. engines/rules_test.cpp compares every rule in lanes.
#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "thinbench/many.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

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
  for (const Index count : {40, 3, 0, 17}) {
    Stack stack = noise_stack(count, 28, 28), expected = stack;
    EXPECT_EQ(thinner(stack.view(), stack.view()), thin_each(Rule::guo_hall, expected));
    EXPECT_TRUE(stack.bytes == expected.bytes) << count;
  }
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
