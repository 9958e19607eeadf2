// Crossings and stars: as drawn_graphs_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "graph/recovery.hpp"

namespace thinbench {
namespace {

constexpr int kArm = 30;  // pixels
constexpr Pixel kMiddle = {kArm, kArm};

Pixel arm_end(Pixel direction) {
  const int times = kArm / std::max(std::abs(direction.x), std::abs(direction.y));
  return {kMiddle.x + times * direction.x, kMiddle.y + times * direction.y};
}

/// Lines from the middle in these directions.
Drawing thin_star(const std::vector<Pixel>& directions) {
  Drawing drawing(2 * kArm + 1, 2 * kArm + 1);
  for (const Pixel direction : directions) drawing.line(kMiddle, arm_end(direction));
  return drawing;
}

/// How many first pixels are joined to the middle: straight ones, and diagonal ones without a
/// straight one beside them.
std::ptrdiff_t joined_arms(const std::vector<Pixel>& directions) {
  Path firsts;
  for (const Pixel direction : directions) {
    firsts.push_back(line_between(kMiddle, arm_end(direction)).at(1));
  }
  const auto is_straight = [](Pixel p) { return p.x == kMiddle.x || p.y == kMiddle.y; };
  return std::count_if(firsts.begin(), firsts.end(), [&](Pixel p) {
    return is_straight(p) || std::none_of(firsts.begin(), firsts.end(), [&](Pixel q) {
             return is_straight(q) && across(p, q) == 1;
           });
  });
}

/// The same, but where arms are so close that first pixels touch, these may be junction pixels,
/// too. It remains one junction if three arms or more are joined to the middle: any other pixel of
/// it is joined to the middle or to a straight first pixel, which then is of the junction. So its
/// centre, and where lines begin, is at most sqrt(2) away from the middle.
Drawing star(const std::vector<Pixel>& directions) {
  Drawing drawing = thin_star(directions);
  const bool allows = !drawing.is_held() && joined_arms(directions) >= 3;
  if (allows) drawing.allow_touching(kMiddle, std::numbers::sqrt2);
  return drawing;
}

/// Of all slopes m / n with m, n <= 5 (the Farey sequence and its mirror images), clockwise; the
/// second half is opposite to the first.
std::vector<Pixel> all_directions() {
  std::vector<Pixel> found;
  for (std::int32_t y = -5; y <= 5; ++y) {
    for (std::int32_t x = -5; x <= 5; ++x) {
      if (std::gcd(x, y) == 1) found.push_back({x, y});
    }
  }
  const auto angle = [](Pixel p) { return std::atan2(-p.y, -p.x); };
  std::sort(found.begin(), found.end(), [&](Pixel a, Pixel b) { return angle(a) < angle(b); });
  return found;
}

/// Between two lines, at most 90 degrees.
double angle_between(Pixel a, Pixel b) {
  const double across = std::abs(a.x * b.y - a.y * b.x);
  return std::atan2(across, std::abs(a.x * b.x + a.y * b.y)) * 180 / std::numbers::pi;
}

// At a small angle, pixels of two lines touch beyond the first ones: what is drawn is a thick line,
// or has holes. And if one line goes on to the east of the middle and the other to the north-east,
// these two pixels are joined, and likewise in the west: two junctions, and the middle is a line
// between them. So which angles the raster holds depends on the slopes: none below 52 degrees, and
// all above 81.
TEST(DrawnGraphs, of_two_lines_are_recovered_at_every_angle_that_the_raster_holds) {
  Recovery recover;
  const std::vector<Pixel> all = all_directions();
  double least = 90;
  double greatest_not_held = 0;
  for (std::size_t i = 0; i < all.size() / 2; ++i) {
    for (std::size_t j = i + 1; j < all.size() / 2; ++j) {
      const Drawing drawing =
          star({all[i], all[j], {-all[i].x, -all[i].y}, {-all[j].x, -all[j].y}});
      const double angle = angle_between(all[i], all[j]);
      if (drawing.is_held()) {
        least = std::min(least, angle);
        recover(drawing);
      } else {
        greatest_not_held = std::max(greatest_not_held, angle);
      }
    }
  }
  EXPECT_EQ(recover.count(), kCrossings);
  EXPECT_NEAR(least, 52.1, 0.1);
  EXPECT_NEAR(greatest_not_held, 80.8, 0.1);
}

/// Two lines drawn from end to end, which have one pixel in common or cross within four pixels.
Drawing crossing(const Path& a, const Path& b) {
  Drawing drawing(2 * kArm + 1, 2 * kArm + 1);
  const auto is_in_b = [&](Pixel p) { return std::find(b.begin(), b.end(), p) != b.end(); };
  const bool has_common = std::any_of(a.begin(), a.end(), is_in_b);
  for (std::size_t i = 1; i < a.size() && !has_common; ++i) {
    const auto [x, y] = a[i];
    const auto [u, v] = a[i - 1];
    if (x != u && y != v && is_in_b({x, v}) && is_in_b({u, y})) {
      drawing.block({std::min(x, u), std::min(y, v)});
    }
  }
  drawing.path(a);
  drawing.path(b);
  return drawing;
}

TEST(DrawnGraphs, of_two_lines_that_cross_anywhere_are_recovered) {
  Recovery recover;
  std::mt19937 random(3);
  const auto draw = [&] { return static_cast<std::int32_t>(random() % (2 * kArm + 1)); };
  std::ptrdiff_t blocks = 0;
  while (recover.count() < kWholeCrossings) {
    const Path across_image = line_between({0, draw()}, {2 * kArm, draw()});
    const Path down = line_between({draw(), 0}, {draw(), 2 * kArm});
    const Drawing drawing = crossing(across_image, down);
    if (!drawing.is_held()) continue;
    recover(drawing);
    const std::vector<TrueNode> nodes = drawing.truth().nodes;
    blocks += std::count_if(nodes.begin(), nodes.end(),
                            [](const TrueNode& node) { return node.x != std::floor(node.x); });
  }
  EXPECT_GE(blocks, 10);
}

TEST(DrawnGraphs, of_stars_with_three_or_four_arms_are_recovered) {
  Recovery recover;
  std::mt19937 random(4);
  const std::vector<Pixel> all = all_directions();
  while (recover.count() < kStars) {
    std::vector<Pixel> directions;
    for (unsigned i = 0; i < 3 + random() % 2; ++i)
      directions.push_back(all[random() % all.size()]);
    const Drawing drawing = star(directions);
    if (drawing.is_held()) recover(drawing);
  }
}

/// Directions of the compass, clockwise from the east, by bits.
std::vector<Pixel> compass(unsigned directions) {
  constexpr std::array<Pixel, 8> steps = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  std::vector<Pixel> found;
  for (unsigned d = 0; d < 8; ++d) {
    if ((directions >> d & 1) != 0) found.push_back(steps[d]);
  }
  return found;
}

TEST(DrawnGraphs, of_stars_with_up_to_eight_arms_are_recovered) {
  Recovery recover;
  for (unsigned directions = 1; directions < 256; ++directions) {
    const Drawing drawing = star(compass(directions));
    if (drawing.is_held()) recover(drawing);
  }
  EXPECT_EQ(recover.count(), kCompassStars);
}

}  // namespace
}  // namespace thinbench
