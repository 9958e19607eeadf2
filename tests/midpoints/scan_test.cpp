// The scanning skeleton: the reference on runs worked by hand, sets of directions, the counters.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "api/catalogue.hpp"
#include "harness/test_images.hpp"
#include "reference.hpp"
#include "midpoints/counter.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

using Picture = std::vector<std::string>;

Directions only(Direction direction) {
  Directions directions = kNoDirections;
  directions.add(direction);
  return directions;
}

Picture marked(const Picture& rows, Directions directions) {
  ByteImage image(static_cast<Index>(rows.front().size()), static_cast<Index>(rows.size()));
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      image.at(x, y) = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
    }
  }
  EXPECT_EQ(reference::skeleton_scan(directions, image.view(), image.view()), 1);
  Picture result = rows;
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      result[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
          image.at(x, y) == 255 ? '#' : '.';
    }
  }
  return result;
}

TEST(ReferenceSkeletonScan, rows_mark_the_middle_or_the_western_of_two) {
  EXPECT_EQ(marked({"#.##.###.####"}, only(Direction::rows)), Picture{"#.#...#...#.."});
}

TEST(ReferenceSkeletonScan, the_frame_ends_runs) {
  EXPECT_EQ(marked({"#####"}, only(Direction::rows)), Picture{"..#.."});
  EXPECT_EQ(marked({"####", "####"}, only(Direction::rows)), (Picture{".#..", ".#.."}));
}

TEST(ReferenceSkeletonScan, columns_mark_the_middle_or_the_northern_of_two) {
  EXPECT_EQ(marked({"#.#", "##.", ".##", "###"}, only(Direction::columns)),
            (Picture{"#.#", "...", ".##", "#.."}));
}

TEST(ReferenceSkeletonScan, diagonals_go_down_to_the_east) {
  EXPECT_EQ(marked({"#...", ".#..", "..#.", "...#"}, only(Direction::diagonals)),
            (Picture{"....", ".#..", "....", "...."}));
  EXPECT_EQ(marked({"..#", ".#.", "#.."}, only(Direction::diagonals)),
            (Picture{"..#", ".#.", "#.."}));
}

TEST(ReferenceSkeletonScan, antidiagonals_go_down_to_the_west) {
  EXPECT_EQ(marked({"...#", "..#.", ".#..", "#..."}, only(Direction::antidiagonals)),
            (Picture{"....", "..#.", "....", "...."}));
  EXPECT_EQ(marked({"..#", ".#.", "#.."}, only(Direction::antidiagonals)),
            (Picture{"...", ".#.", "..."}));
}

TEST(ReferenceSkeletonScan, result_is_the_union_of_all_directions) {
  // Diagonals of 1, 2, 3, 2, 1 pixels add the corners and the northern pixels of the pairs.
  EXPECT_EQ(marked({"###", "###", "###"}, Directions{}), (Picture{"###", "###", "###"}));
  Directions two = only(Direction::rows);
  two.add(Direction::columns);
  EXPECT_EQ(marked({"###", "###", "###"}, two), (Picture{".#.", "###", ".#."}));
  EXPECT_EQ(marked({"###"}, kNoDirections), Picture{"..."});
}

TEST(SkeletonScan, every_variant_takes_every_set_of_directions) {
  const ThinningOperation& operation = *find_thinning_operation("skeleton_scan");
  for (const Index width : {70, 511, 512, 600}) {
    const ByteImage image = noise_image(width, 150, 75, 9, 11);
    ByteImage expected(width, 150);
    ByteImage found(width, 150);
    for (int bits = 0; bits < 16; ++bits) {
      const Directions directions = {static_cast<std::uint8_t>(bits)};
      reference::skeleton_scan(directions, image.view(), expected.view());
      for (const ThinningVariant& variant : operation.variants) {
        if (!unavailable_reason(variant, width).empty()) continue;
        PlanOptions options{.threads = 3};
        options.directions = directions;
        ThinningPlan plan(operation, variant, width, 150, options);
        EXPECT_EQ(plan.run(image.view(), found.view()), 1);
        EXPECT_TRUE(equal(found.view(), expected.view()))
            << technique_name(variant.technique) << " at " << isa_name(variant.isa) << ", set "
            << bits << ", width " << width;
      }
    }
  }
}

TEST(SkeletonScan, runs_longer_than_short_counters_keep_their_centres) {
  const ThinningOperation& operation = *find_thinning_operation("skeleton_scan");
  constexpr std::pair<Index, Index> kSizes[] = {{70000, 2}, {2, 70000},  {65534, 1},
                                                {65535, 1}, {32767, 1},  {1, 65535},
                                                {2100, 40}, {130, 2100}, {512, 520}};
  for (const auto& [width, height] : kSizes) {
    ByteImage dark(width, height);
    for (Index y = 0; y < height; ++y) std::fill_n(dark.view().row(y), width, std::uint8_t{255});
    ByteImage expected(width, height);
    ByteImage found(width, height);
    reference::skeleton_scan(Directions{}, dark.view(), expected.view());
    for (const ThinningVariant& variant : operation.variants) {
      if (!unavailable_reason(variant, width).empty() || variant.threaded) continue;
      ThinningPlan plan(operation, variant, width, height, {});
      plan.run(dark.view(), found.view());
      EXPECT_TRUE(equal(found.view(), expected.view()))
          << technique_name(variant.technique) << " at " << isa_name(variant.isa) << ", " << width
          << " x " << height;
    }
  }
}

TEST(SkeletonScan, other_operations_take_no_directions) {
  ByteImage image(5, 5);
  Options options;
  options.directions = Directions{};
  EXPECT_EQ(thin("skeleton_scan", image.view(), image.view(), options), 1);
  EXPECT_THROW(thin("thin_mb2", image.view(), image.view(), options), std::invalid_argument);
}

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

TEST(RunCounter, takes_every_state_but_one_before_the_first_comes_back) {
  EXPECT_EQ(period<7>(), 127U);
  EXPECT_EQ(period<9>(), 511U);
  EXPECT_EQ(period<11>(), 2047U);
  EXPECT_EQ(period<15>(), 32767U);
}

/// x to the power of `exponent` modulo x^41 + x^3 + 1, over two elements.
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

TEST(RunCounter, the_longest_has_a_primitive_polynomial) {
  ASSERT_EQ(feedback_place(41), 38);
  constexpr std::uint64_t states = (std::uint64_t{1} << 41) - 1;
  static_assert(states == std::uint64_t{13367} * 164511353, "its prime factors");
  EXPECT_EQ(power_of_x(states), 1U);
  EXPECT_NE(power_of_x(states / 13367), 1U);
  EXPECT_NE(power_of_x(states / 164511353), 1U);
}

TEST(CounterBits, tell_apart_all_counts) {
  EXPECT_EQ(counter_bits(0), 7);
  EXPECT_EQ(counter_bits(126), 7);
  EXPECT_EQ(counter_bits(127), 9);
  EXPECT_EQ(counter_bits(510), 9);
  EXPECT_EQ(counter_bits(511), 11);
  EXPECT_EQ(counter_bits(Index{1} << 40), 41);
}

}  // namespace
}  // namespace thinbench
