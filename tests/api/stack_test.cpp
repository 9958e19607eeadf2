// StackThinner: iterations and moves.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/untouched.hpp"
#include "thinbench/many.hpp"

namespace thinbench {
namespace {

TEST(ThinStack, takes_no_iteration_for_an_empty_stack_and_one_for_images_without_pixels) {
  EXPECT_EQ(thin_stack(Rule::guo_hall, ConstStackView{}, StackView{}), 0);
  EXPECT_EQ(thin_stack(Rule::guo_hall, {nullptr, 0, 28, 28}, {nullptr, 0, 28, 28}), 0);
  EXPECT_EQ(thin_stack(Rule::guo_hall, {nullptr, 3, 0, 28}, {nullptr, 3, 0, 28}), 1);
  EXPECT_EQ(thin_stack(Rule::mb2, {nullptr, 3, 28, 0}, {nullptr, 3, 28, 0}), 1);
}

TEST(StackThinner, works_after_a_move) {
  static_assert(!std::is_copy_constructible_v<StackThinner>);
  static_assert(std::is_nothrow_move_constructible_v<StackThinner>);
  static_assert(std::is_nothrow_move_assignable_v<StackThinner>);
  std::vector<std::uint8_t> pixels(2 * 28 * 28, 255);
  const StackView stack = {pixels.data(), 2, 28, 28};
  StackThinner first(Rule::zhang_suen, 28, 28);
  const int iterations = first(stack, stack);
  StackThinner second(std::move(first));
  first = StackThinner(Rule::mb2, 5, 5);
  std::fill(pixels.begin(), pixels.end(), std::uint8_t{255});
  EXPECT_EQ(second(stack, stack), iterations);
}

TEST(ThinStack, rejects_invalid_stacks) {
  constexpr Index huge = std::numeric_limits<Index>::max() / 2;
  Untouched from, to;
  std::uint8_t* const data = from.data();
  const std::string overlap = "source and destination overlap without being the same images";
  const StackView four = {to.data(), 4, 5, 5, 5, 25};
  struct Case {
    ConstStackView source;
    StackView destination;
    std::string part;
  };
  const Case cases[] = {
      {{data, -1, 5, 5, 5, 25}, four, "source is -1 images of 5 x 5; counts and sizes cannot be"},
      {{data, 4, 5, -5, 5, 25}, four, "source is 4 images of 5 x -5; counts and sizes cannot be"},
      {{data, 4, 5, 5, 4, 25}, four, "source has a stride of 4 bytes, below its width of 5"},
      {{data, 4, 5, 5, 5, 24}, four, "an image stride of 24 bytes; its images take 25"},
      {{data, huge, 5, 5, 5, 25}, four, "address space: 4611686018427387903 images of 5 x 5"},
      {{data, 4, 5, huge, 5, 25}, four, "address space: 4 images of 5 x 4611686018427387903"},
      {{data, 3, 5, 5, 5, 25},
       four,
       "source is 3 images of 5 x 5 and destination 4 images of 5 x 5; they must have the same"},
      {{nullptr, 4, 5, 5, 5, 25}, four, "source has no data"},
      {{data, 4, 5, 5, 5, 25}, {nullptr, 4, 5, 5, 5, 25}, "destination has no data"},
      {{data + 1, 3, 5, 5, 5, 25}, {data, 3, 5, 5, 5, 25}, overlap},
      {{data, 3, 5, 5, 5, 50}, {data + 25, 3, 5, 5, 5, 50}, overlap},  // interleaved
  };
  for (const auto& [source, destination, part] : cases) {
    expect_rejected([&, in = source, out = destination] { thin_stack(Rule::guo_hall, in, out); },
                    part);
  }
}

}  // namespace
}  // namespace thinbench
