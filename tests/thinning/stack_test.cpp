// Stacks of images against the reference: every rule, border, iteration limit and ISA.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "engines/lanes.hpp"
#include "harness/splitmix64.hpp"
#include "harness/test_images.hpp"
#include "support/edge_case_images.hpp"
#include "support/reference_thinning.hpp"
#include "support/rule_parameters.hpp"
#include "thinbench/many.hpp"

namespace thinbench {
namespace {

constexpr std::uint8_t kGap = 0x5A;

/// A stack of images with gaps between rows and between images.
class Stack {
 public:
  Stack(Index count, Index width, Index height, Index row_gap = 0, Index image_gap = 0)
      : view_{nullptr, count,           width,
              height,  width + row_gap, height * (width + row_gap) + image_gap},
        bytes_(static_cast<std::size_t>(count * view_.image_stride), kGap) {}

  [[nodiscard]] StackView view() {
    StackView view = view_;
    view.data = bytes_.data();
    return view;
  }

  void set(Index i, const ConstImageView& image) {
    for (Index y = 0; y < image.height; ++y) {
      std::copy_n(image.row(y), image.width, view().image(i).row(y));
    }
  }

  /// Whether the gaps are unwritten.
  [[nodiscard]] bool gaps_are_intact() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const auto in_image = static_cast<Index>(i) % view_.image_stride;
      const bool pixel =
          in_image < view_.height * view_.stride && in_image % view_.stride < view_.width;
      if (!pixel && bytes_[i] != kGap) return false;
    }
    return true;
  }

 private:
  StackView view_;
  std::vector<std::uint8_t> bytes_;
};

/// Noise of all densities and block sizes, with some other edge cases.
Stack random_stack(Index count, Index width, Index height, std::uint64_t seed) {
  Stack stack(count, width, height, static_cast<Index>(seed % 4), static_cast<Index>(seed % 3));
  for (Index i = 0; i < count; ++i) {
    const std::uint64_t random = splitmix64(seed, static_cast<std::uint64_t>(i));
    const int percent = static_cast<int>(random % 101);
    const Index granularity = 1 + static_cast<Index>(random >> 32) % 5;
    ByteImage image = noise_image(width, height, percent, granularity, random);
    if (random >> 60 == 0) image = filled_image(width, height, 255);
    if (random >> 60 == 1) image = edge_case_images::shapes_on_every_side(width, height);
    stack.set(i, image.view());
  }
  return stack;
}

struct Expected {
  Stack images;
  int iterations;
};

Expected expected_of(const Rule& rule, const reference::Repetition& repetition, Stack& source) {
  const StackView view = source.view();
  Expected expected = {Stack(view.count, view.width, view.height), 0};
  for (Index i = 0; i < view.count; ++i) {
    const int iterations =
        thin_by_reference(rule, repetition, view.image(i), expected.images.view().image(i));
    expected.iterations = std::max(expected.iterations, iterations);
  }
  return expected;
}

/// The index of the first image that differs, or -1.
Index first_difference(StackView a, StackView b) {
  for (Index i = 0; i < a.count; ++i) {
    if (!equal(a.image(i), b.image(i))) return i;
  }
  return -1;
}

void expect_stack(const Rule& rule, Stack& source, const Thinning& thinning,
                  const Execution& execution, Expected& expected) {
  const StackView in = source.view();
  Stack out(in.count, in.width, in.height, 3, 5);
  const int iterations = thin_stack(rule, in, out.view(), thinning, execution);
  const bool same = iterations == expected.iterations &&
                    first_difference(out.view(), expected.images.view()) == -1 &&
                    out.gaps_are_intact();
  ASSERT_TRUE(same) << rule.name() << ", " << in.count << " images of " << in.width << " x "
                    << in.height << " at " << isa_name(execution.isa.value_or(best_isa()))
                    << ", limit " << thinning.max_iterations.value_or(kUnlimited) << ", threads "
                    << execution.threads << ": " << iterations << " iterations instead of "
                    << expected.iterations;
}

void expect_stack_at_every_isa(const Rule& rule, Stack& source,
                               const reference::Repetition& repetition, int threads) {
  Expected expected = expected_of(rule, repetition, source);
  const Thinning thinning = {repetition.border, repetition.max_iterations};
  Execution execution = {.threads = threads};
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    execution.isa = isa;
    expect_stack(rule, source, thinning, execution, expected);
    if (testing::Test::HasFatalFailure()) return;
  }
}

class StackOf : public testing::TestWithParam<RuleAndBorder> {
 protected:
  [[nodiscard]] static const Rule& rule() { return GetParam().rule; }
  [[nodiscard]] static Border border() { return GetParam().border; }
};

/// To save time, a rule has one border at each width. Another test has all borders at some widths.
TEST_P(StackOf, random_images_of_every_width_equals_the_reference) {
  const Index borders = rule().sub_iterations().empty() ? 2 : 3;
  const Index first_width =
      1 + (static_cast<Index>(GetParam().name.size()) + static_cast<Index>(border())) % borders;
  for (Index width = first_width; width <= detail::kMaxLaneWidth + 2; width += borders) {
    const std::uint64_t random = splitmix64(17, static_cast<std::uint64_t>(width));
    const Index height = 1 + static_cast<Index>(random % 70);
    const Index count = 1 + static_cast<Index>((random >> 16) % (width <= 64 ? 40 : 12));
    Stack source = random_stack(count, width, height, random);
    const int limits[] = {1, 2, 3, kUnlimited};
    const auto first = static_cast<std::size_t>((random >> 32) % 3);
    for (const int limit : {limits[first], kUnlimited}) {
      expect_stack_at_every_isa(rule(), source, {border(), limit}, width % 8 == 0 ? 3 : 1);
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(StackOf, narrow_and_low_images_equals_the_reference_at_every_limit) {
  for (const Index width : {1, 2, 3, 16, 17, 32, 33, 64, 65, 127, 128, 129}) {
    for (const Index height : {1, 2, 3, 28}) {
      Stack source =
          random_stack(19, width, height, static_cast<std::uint64_t>(3 + 100 * width + height));
      for (const int limit : {1, 2, 3, kUnlimited}) {
        expect_stack_at_every_isa(rule(), source, {border(), limit}, 1);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST_P(StackOf, all_images_of_four_by_four_equals_the_reference) {
  constexpr int count = 1 << 14;  // a quarter of all images; each quarter has another limit
  const int limits[] = {kUnlimited, 1, 2, 3};
  for (int quarter = 0; quarter < 4; ++quarter) {
    Stack source(count, 4, 4);
    for (int i = 0; i < count; ++i) {
      // The odd factor permutes the images, so that each quarter has all values of the upper
      // pixels.
      const auto bits = static_cast<std::uint64_t>(count * quarter + i) * 40503 & 0xFFFF;
      source.set(i, image_of_bits(4, 4, bits).view());
    }
    expect_stack_at_every_isa(rule(), source, {border(), limits[quarter]}, 1);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, StackOf, all_rules_and_borders(), rule_and_border_test_name);

TEST(StackThinner, treats_any_nonzero_byte_as_foreground) {
  Stack source(2, 5, 5);
  Stack binary(2, 5, 5);
  for (Index i = 0; i < 2; ++i) {
    ByteImage image = noise_image(5, 5, 80, 1, 3);
    binary.set(i, image.view());
    for (Index x = 0; x < 25; ++x) {
      std::uint8_t& pixel = image.at(x % 5, x / 5);
      pixel = pixel == 0 ? 0 : static_cast<std::uint8_t>(1 + x);
    }
    source.set(i, image.view());
  }
  Expected expected = expected_of(Rule::guo_hall, {}, binary);
  expect_stack(Rule::guo_hall, source, {}, {}, expected);
}

TEST(StackThinner, works_in_place) {
  for (const Index width : {28, 64, 128, 150}) {
    Stack source = random_stack(37, width, 20, 8);
    Expected expected = expected_of(Rule::zhang_suen, {}, source);
    EXPECT_EQ(thin_stack(Rule::zhang_suen, source.view(), source.view()), expected.iterations);
    EXPECT_EQ(first_difference(source.view(), expected.images.view()), -1);
    EXPECT_TRUE(source.gaps_are_intact());
  }
}

TEST(StackThinner, threads_share_the_images_with_and_without_lanes) {
  for (const Index width : {28, 140}) {
    Stack source = random_stack(100, width, 12, 4);
    Expected expected = expected_of(Rule::guo_hall, {}, source);
    for (const int threads : {2, 3, 7}) {
      expect_stack(Rule::guo_hall, source, {}, {.threads = threads}, expected);
    }
  }
}

TEST(StackThinner, thins_large_images_on_a_thread_each_and_the_last_ones_on_all) {
  Stack source = random_stack(3, 1100, 1000, 4);
  Expected expected = expected_of(Rule::guo_hall, {}, source);
  for (const int threads : {1, 2, 3, 4}) {
    expect_stack(Rule::guo_hall, source, {}, {.threads = threads}, expected);
  }
}

TEST(StackThinner, takes_a_different_number_of_images_in_each_call) {
  StackThinner thinner(Rule::guo_hall, 28, 28, {}, {.threads = 2});
  for (const Index count : {40, 3, 0, 17}) {
    Stack source = random_stack(count, 28, 28, static_cast<std::uint64_t>(count));
    Expected expected = expected_of(Rule::guo_hall, {}, source);
    Stack out(count, 28, 28);
    EXPECT_EQ(thinner(source.view(), out.view()), expected.iterations);
    EXPECT_EQ(first_difference(out.view(), expected.images.view()), -1);
  }
}

}  // namespace
}  // namespace thinbench
