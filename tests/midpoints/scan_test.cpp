// The midpoint scan: the reference on hand-worked runs, all variants, the run counters.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "midpoints/counter.hpp"
#include "midpoints/work.hpp"
#include "reference.hpp"
#include "support/made_image.hpp"
#include "support/variant_of.hpp"
#include "thinbench/midpoint_scan.hpp"

namespace thinbench::detail {
namespace {

Directions only(Direction direction) {
  Directions directions = kNoDirections;
  directions.add(direction);
  return directions;
}

/// The marks of the reference.
TextImage marked(const TextImage& lines, Directions directions, Border border) {
  ByteImage image = image_of(lines);
  EXPECT_EQ(reference::midpoint_scan(directions, border, image.view(), image.view()), 1);
  return text_of(image);
}

TEST(ReferenceMidpointScan, marks_the_middle_of_each_run_or_the_first_of_two) {
  Directions two = only(Direction::rows);
  two.add(Direction::columns);
  const TextImage square = {"###", "###", "###"};
  struct Case {
    TextImage image;
    Directions directions;
    TextImage marks;
    Border border = Border::background;
  };
  for (const auto& [image, directions, marks, border] : std::vector<Case>{
           {{"#.##.###.####"}, only(Direction::rows), {"#.#...#...#.."}},
           {{"#####"}, only(Direction::rows), {"..#.."}},  // runs end at the image border
           {{"####", "####"}, only(Direction::rows), {".#..", ".#.."}},
           {{"#.#", "##.", ".##", "###"}, only(Direction::columns), {"#.#", "...", ".##", "#.."}},
           {{"#...", ".#..", "..#.", "...#"},
            only(Direction::diagonals),
            {"....", ".#..", "....", "...."}},
           {{"..#", ".#.", "#.."}, only(Direction::diagonals), {"..#", ".#.", "#.."}},
           {{"...#", "..#.", ".#..", "#..."},
            only(Direction::antidiagonals),
            {"....", "..#.", "....", "...."}},
           {{"..#", ".#.", "#.."}, only(Direction::antidiagonals), {"...", ".#.", "..."}},
           // Diagonals of 1, 2, 3, 2, 1 pixels add the corners and the north pixel of each pair.
           {square, Directions{}, square},
           {square, two, {".#.", "###", ".#."}},
           {{"###"}, kNoDirections, {"..."}},
           {square, only(Direction::rows), square, Border::keep},
           {{"#####", "#####", ".....", "####."},
            only(Direction::rows),
            {"#####", "#.#.#", ".....", "####."},
            Border::keep},
           {{"####"}, kNoDirections, {"####"}, Border::keep}}) {
    EXPECT_EQ(marked(image, directions, border), marks) << testing::PrintToString(image);
  }
}

/// Calls `check(state, name)` for a new state of each variant that can run here.
template <class Check>
void for_each_state(const MidpointParameters& parameters, Index width, Index height, int threads,
                    const Check& check) {
  for (const auto& variant : study::midpoint_operation().variants) {
    if (!unavailable_reason(variant, width).empty()) continue;
    check(*make_state(variant, width, height, parameters, threads), name_of(variant));
  }
}

TEST(MidpointScan, every_variant_equals_the_reference_with_every_set_of_directions_and_border) {
  constexpr Index height = 150;
  for (const Index width : {70, 511, 512, 600}) {
    const ByteImage image = noise_image(width, height, 75, 9, 11);
    const ByteImage first_image = noise_image(width, height, 75, 9, 12);
    ByteImage expected(width, height);
    ByteImage found(width, height);
    for (int bits = 0; bits < 32; ++bits) {
      const Directions directions = {static_cast<std::uint8_t>(bits % 16)};
      const Border border = bits < 16 ? Border::background : Border::keep;
      reference::midpoint_scan(directions, border, image.view(), expected.view());
      for_each_state({directions, border}, width, height, 3,
                     [&](MidpointState& state, const std::string& name) {
                       state.run(first_image.view(), found.view());
                       state.run(image.view(), found.view());
                       EXPECT_TRUE(equal(found.view(), expected.view()))
                           << name << ", " << width << " wide, set " << bits;
                     });
    }
  }
}

TEST(MidpointScan, every_variant_equals_the_reference_on_runs_longer_than_short_counters) {
  constexpr std::pair<Index, Index> kSizes[] = {{70000, 2}, {2, 70000},  {65534, 1},
                                                {65535, 1}, {32767, 1},  {1, 65535},
                                                {2100, 40}, {130, 2100}, {512, 520}};
  for (const auto& [width, height] : kSizes) {
    const ByteImage full = filled_image(width, height, 255);
    ByteImage expected(width, height);
    ByteImage found(width, height);
    reference::midpoint_scan(Directions{}, Border::background, full.view(), expected.view());
    for_each_state({{}, Border::background}, width, height, 1,
                   [&](MidpointState& state, const std::string& name) {
                     state.run(full.view(), found.view());
                     EXPECT_TRUE(equal(found.view(), expected.view()))
                         << name << ", " << full.width();
                   });
  }
}

TEST(MidpointScan, may_be_in_place_and_takes_images_without_pixels) {
  ByteImage image = noise_image(70, 30, 75, 4, 2);
  ByteImage expected(70, 30);
  reference::midpoint_scan({}, Border::keep, image.view(), expected.view());
  midpoint_scan(image.view(), image.view(), {}, Border::keep);
  EXPECT_TRUE(equal(image.view(), expected.view()));
  midpoint_scan({nullptr, 0, 5}, {nullptr, 0, 5});
}

/// The number of steps until the counter returns to its first state.
template <int bits>
std::uint64_t period() {
  RunCounter<std::uint64_t, bits> counter;
  counter.clear();
  for (std::uint64_t steps = 1;; ++steps) {
    counter.count(1);
    std::uint64_t any = 0;
    for (const std::uint64_t bit : counter.bit) any |= bit;
    if (any == 0) return steps;
  }
}

TEST(RunCounter, has_a_period_of_2_to_the_bits_minus_1) {
  EXPECT_EQ(period<7>(), 127U);
  EXPECT_EQ(period<9>(), 511U);
  EXPECT_EQ(period<11>(), 2047U);
  EXPECT_EQ(period<15>(), 32767U);
}

/// x to the power of `exponent` modulo x^41 + x^3 + 1, over GF(2).
std::uint64_t power_of_x(std::uint64_t exponent) {
  const auto product = [](std::uint64_t a, std::uint64_t b) {
    std::uint64_t sum = 0;
    for (; b != 0; b >>= 1) {
      if ((b & 1) != 0) sum ^= a;
      a = (a & (std::uint64_t{1} << 40)) != 0 ? ((a << 1) ^ (std::uint64_t{1} << 41) ^ 9) : a << 1;
    }
    return sum;
  };
  std::uint64_t result = 1;
  for (std::uint64_t square = 2; exponent != 0; exponent >>= 1, square = product(square, square)) {
    if ((exponent & 1) != 0) result = product(result, square);
  }
  return result;
}

TEST(RunCounter, longest_counter_has_a_primitive_polynomial) {
  ASSERT_EQ(feedback_tap(41), 38);
  constexpr std::uint64_t states = (std::uint64_t{1} << 41) - 1;
  static_assert(states == std::uint64_t{13367} * 164511353, "its prime factors");
  EXPECT_EQ(power_of_x(states), 1U);
  EXPECT_NE(power_of_x(states / 13367), 1U);
  EXPECT_NE(power_of_x(states / 164511353), 1U);
}

TEST(CounterBits, suffice_for_distinct_states_of_all_counts) {
  EXPECT_EQ(counter_bits(0), 7);
  EXPECT_EQ(counter_bits(126), 7);
  EXPECT_EQ(counter_bits(127), 9);
  EXPECT_EQ(counter_bits(510), 9);
  EXPECT_EQ(counter_bits(511), 11);
  EXPECT_EQ(counter_bits(Index{1} << 40), 41);
}

}  // namespace
}  // namespace thinbench::detail
