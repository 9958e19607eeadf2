// ThinningBatch: iterations, rejected arguments, moves.
#include "thinbench/batch.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/isa_parameters.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kUntouched = 0x5A;

TEST(ThinBatch, takes_no_iteration_for_an_empty_stack_and_one_for_images_without_pixels) {
  EXPECT_EQ(thin_batch(Rule::guo_hall, ConstStackView{}, StackView{}), 0);
  EXPECT_EQ(thin_batch(Rule::guo_hall, {nullptr, 0, 28, 28}, {nullptr, 0, 28, 28}), 0);
  EXPECT_EQ(thin_batch(Rule::guo_hall, {nullptr, 3, 0, 28}, {nullptr, 3, 0, 28}), 1);
  EXPECT_EQ(thin_batch(Rule::mb2, {nullptr, 3, 28, 0}, {nullptr, 3, 28, 0}), 1);
}

/// The error for these stacks.
std::string rejected_stacks(const ConstStackView& source, const StackView& destination) {
  return rejection_of([&] { thin_batch(Rule::guo_hall, source, destination); });
}

TEST(ThinBatch, rejects_invalid_stacks) {
  std::vector<std::uint8_t> from(100, kUntouched);
  std::vector<std::uint8_t> to(100, kUntouched);
  const StackView good = {to.data(), 4, 5, 5, 5, 25};
  const auto rejected = [&](Index count, Index width, Index height, Index stride, Index image) {
    return rejected_stacks({from.data(), count, width, height, stride, image}, good);
  };
  EXPECT_EQ(rejected(-1, 5, 5, 5, 25),
            "source is -1 images of 5 x 5; counts and sizes cannot be negative");
  EXPECT_EQ(rejected(4, 5, -5, 5, 25),
            "source is 4 images of 5 x -5; counts and sizes cannot be negative");
  EXPECT_EQ(rejected(4, 5, 5, 4, 25), "source has a stride of 4 bytes, below its width of 5");
  EXPECT_EQ(rejected(4, 5, 5, 5, 24), "source has an image stride of 24 bytes; its images take 25");
  EXPECT_EQ(rejected(PTRDIFF_MAX / 2, 5, 5, 5, 25),
            "source exceeds the address space: 4611686018427387903 images of 5 x 5, strides "
            "5 and 25");
  EXPECT_EQ(rejected(4, 5, PTRDIFF_MAX / 2, 5, 25),
            "source exceeds the address space: 4 images of 5 x 4611686018427387903, strides "
            "5 and 25");
  EXPECT_EQ(rejected(3, 5, 5, 5, 25),
            "source is 3 images of 5 x 5 and destination 4 images of 5 x 5; they must have the "
            "same count and size");
  EXPECT_EQ(rejected_stacks({nullptr, 4, 5, 5, 5, 25}, good), "source has no data");
  EXPECT_EQ(rejected_stacks({from.data(), 4, 5, 5, 5, 25}, {nullptr, 4, 5, 5, 5, 25}),
            "destination has no data");
  EXPECT_EQ(rejected_stacks({to.data() + 1, 3, 5, 5, 5, 25}, {to.data(), 3, 5, 5, 5, 25}),
            "source and destination overlap without being the same images");
  EXPECT_TRUE(
      std::all_of(to.begin(), to.end(), [](std::uint8_t byte) { return byte == kUntouched; }));
}

TEST(ThinBatch, rejects_stacks_with_interleaved_images_as_overlapping) {
  std::vector<std::uint8_t> both(200, kUntouched);
  EXPECT_EQ(rejected_stacks({both.data(), 3, 5, 5, 5, 50}, {both.data() + 25, 3, 5, 5, 5, 50}),
            "source and destination overlap without being the same images");
}

/// The error for these options; checks that nothing was written.
std::string rejected_options(const Rule& rule, const Thinning& thinning,
                             const Execution& execution = {}, Index width = 5) {
  std::vector<std::uint8_t> pixels(50 * 5, kUntouched);
  const StackView stack = {pixels.data(), 2, 5, 5, 5, 25};
  const std::string text =
      rejection_of([&] { ThinningBatch(rule, width, 5, thinning, execution); });
  EXPECT_TRUE(is_one_sentence(text)) << text;
  if (width == 5) {
    EXPECT_EQ(rejection_of([&] { thin_batch(rule, stack, stack, thinning, execution); }), text);
  }
  EXPECT_TRUE(std::all_of(pixels.begin(), pixels.end(),
                          [](std::uint8_t byte) { return byte == kUntouched; }));
  return text;
}

TEST(ThinningBatch, rejects_unsuitable_options) {
  EXPECT_EQ(rejected_options(Rule::guo_hall, {}, {.threads = 0}),
            "threads: expected an integer in [1, 1024], got 0");
  EXPECT_EQ(rejected_options(Rule::guo_hall, {.max_iterations = 0}),
            "max_iterations: expected an integer of at least 1, got 0");
  EXPECT_EQ(rejected_options(Rule::guo_hall, {}, {}, -5), "image size -5 x 5 is negative");
  EXPECT_EQ(rejected_options(Rule::spta, {}, {.isa = Isa::avx2}),
            "thin_spta at avx2 on one thread: its instruction sets are baseline");
}

TEST(ThinningBatch, rejects_invalid_enumerators) {
  EXPECT_EQ(rejected_options(Rule::mb2, {}, {.isa = static_cast<Isa>(99)}),
            "isa: expected one of " + all_isa_names() + ", got number 99");
  EXPECT_EQ(rejected_options(Rule::mb2, {.border = static_cast<Border>(3)}),
            "border: expected background, keep or foreground, got 3");
}

TEST(ThinningBatch, rejects_images_of_another_size) {
  std::vector<std::uint8_t> pixels(60, kUntouched);
  const StackView stack = {pixels.data(), 2, 5, 6};
  ThinningBatch batch(Rule::guo_hall, 28, 28);
  EXPECT_EQ(rejection_of([&] { batch(stack, stack); }), "expected images of 28 x 28, got 5 x 6");
  const StackView lower = {pixels.data(), 1, 28, 2};
  EXPECT_EQ(rejection_of([&] { batch(lower, lower); }), "expected images of 28 x 28, got 28 x 2");
  EXPECT_TRUE(std::all_of(pixels.begin(), pixels.end(),
                          [](std::uint8_t byte) { return byte == kUntouched; }));
}

TEST(ThinningBatch, works_after_a_move) {
  static_assert(!std::is_copy_constructible_v<ThinningBatch>);
  static_assert(std::is_nothrow_move_constructible_v<ThinningBatch>);
  static_assert(std::is_nothrow_move_assignable_v<ThinningBatch>);
  std::vector<std::uint8_t> pixels(2 * 28 * 28, 255);
  const StackView stack = {pixels.data(), 2, 28, 28};
  ThinningBatch first(Rule::zhang_suen, 28, 28);
  const int iterations = first(stack, stack);
  ThinningBatch second(std::move(first));
  first = ThinningBatch(Rule::spta, 5, 5);
  std::fill(pixels.begin(), pixels.end(), std::uint8_t{255});
  EXPECT_EQ(second(stack, stack), iterations);
}

}  // namespace
}  // namespace thinbench
