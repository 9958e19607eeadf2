// Polylines equal those of the plain method, and take no time that grows with the square of the
// line's length.
#include <array>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "graph.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

using Line = std::vector<Pixel>;

constexpr std::array<double, 7> kTolerances = {0, 0.1, 0.5, 0.7, 1, 2.5, 40};

void must_equal_the_plain_method(const Line& points) {
  for (const double tolerance : kTolerances) {
    for (const Spacing spacing : {Spacing{1, 1}, Spacing{0.5, 2}}) {
      ASSERT_EQ(polyline(points, tolerance, spacing),
                reference::polyline(points, tolerance, spacing))
          << points.size() << " points, tolerance " << tolerance;
    }
  }
}

void go(Line& line, Pixel step, std::int32_t steps) {
  for (; steps > 0; --steps) line.push_back({line.back().x + step.x, line.back().y + step.y});
}

/// A square wave whose amplitude grows with each tooth, along a row or a diagonal.
Line square_wave(std::int32_t teeth, std::int32_t start, std::int32_t growth, bool is_diagonal) {
  const Pixel along = is_diagonal ? Pixel{1, 1} : Pixel{1, 0};
  const Pixel up = is_diagonal ? Pixel{1, -1} : Pixel{0, -1};
  Line line = {{0, 0}};
  for (std::int32_t tooth = 0; tooth < teeth; ++tooth) {
    const std::int32_t height = start + growth * tooth;
    go(line, up, height);
    go(line, along, 2);
    go(line, {-up.x, -up.y}, height);
    go(line, along, 2);
  }
  return line;
}

TEST(Polyline, equals_the_plain_method_on_random_walks) {
  std::mt19937 random(1);
  for (int walk = 0; walk < 300; ++walk) {
    Line line = {{0, 0}};
    const std::size_t length = 1 + random() % 2000;
    const std::int32_t reach = 1 + static_cast<std::int32_t>(random() % 3);
    std::uniform_int_distribution<std::int32_t> step(-reach, reach);
    while (line.size() < length) {
      line.push_back({line.back().x + step(random), line.back().y + step(random)});
    }
    must_equal_the_plain_method(line);
  }
}

// Few places, so many ties, and many points at the places of others.
TEST(Polyline, equals_the_plain_method_on_scattered_points) {
  std::mt19937 random(2);
  for (const std::int32_t side : {1, 2, 3, 5, 10, 1000, 9000}) {
    std::uniform_int_distribution<std::int32_t> place(0, side - 1);
    for (int i = 0; i < 40; ++i) {
      Line line(1 + random() % 1000);
      for (Pixel& p : line) p = {place(random), place(random)};
      must_equal_the_plain_method(line);
      line.back() = line.front();
      must_equal_the_plain_method(line);
    }
  }
}

TEST(Polyline, equals_the_plain_method_on_square_waves) {
  for (const bool is_diagonal : {false, true}) {
    for (const std::int32_t growth : {-3, -1, 0, 1, 2}) {
      const Line line = square_wave(60, growth < 0 ? 200 : 4, growth, is_diagonal);
      must_equal_the_plain_method(line);
      must_equal_the_plain_method({line.rbegin(), line.rend()});
    }
  }
}

TEST(Polyline, measures_from_lines_of_one_step_too) {
  const Line points = {{0, 0}, {4, 0}, {1, 0}};
  EXPECT_EQ(polyline(points, 3), (Line{{0, 0}, {1, 0}}));
}

TEST(Polyline, of_straight_lines_has_two_points_without_any_tolerance) {
  for (std::int32_t length = 2; length <= 500; ++length) {
    Line row, diagonal;
    for (std::int32_t i = 0; i < length; ++i) {
      row.push_back({7, 3 + i});
      diagonal.push_back({1 + i, 9 - i});
    }
    ASSERT_EQ(polyline(row, 0).size(), 2U);
    ASSERT_EQ(polyline(diagonal, 0).size(), 2U);
  }
}

TEST(Polyline, takes_points_as_far_apart_as_numbers_allow) {
  constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();
  const Line points = {{-far - 1, 0}, {0, 3}, {far, 0}};
  EXPECT_EQ(polyline(points, 3.5), (Line{points[0], points[2]}));
  EXPECT_EQ(polyline(points, 2.5), points);
}

template <class Method>
double processor_seconds(const Method& method) {
  const std::clock_t start = std::clock();
  EXPECT_EQ(method().size(), 2400U + 1);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Each of the 2400 corners but a few is split off by a look at all that is left.
TEST(Polyline, of_a_wave_of_growing_amplitude_takes_a_small_part_of_the_plain_method_s_time) {
#ifndef __OPTIMIZE__
  GTEST_SKIP() << "says nothing about code that is not optimised";
#endif
  const Line line = square_wave(600, 2, 2, false);
  const double plain = processor_seconds([&] { return reference::polyline(line, 0.5); });
  EXPECT_LT(processor_seconds([&] { return polyline(line, 0.5); }), plain / 2);
}

TEST(Polyline, has_the_length_of_its_straight_lines) {
  const Line points = {{0, 0}, {3, 4}, {3, 4}, {6, 0}};
  EXPECT_DOUBLE_EQ(length_of(points), 10);
  EXPECT_DOUBLE_EQ(length_of(points, {.x = 4, .y = 1.25}), 26);
  EXPECT_EQ(length_of(Line{}), 0);
  EXPECT_EQ(polyline({}, 1), Line());
}

}  // namespace
}  // namespace thinbench
