#include "thinbench/path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "support/made_image.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

/// Two rooms with a wide door at the bottom and a narrow one at the top.
const TextImage kRooms = {"#######.#######",  //
                          "###############",  //
                          "#######.#######",  //
                          "#######.#######",  //
                          "###############",  //
                          "###############",  //
                          "###############",  //
                          "#######.#######"};

TEST(FindPath, of_a_wide_robot_leads_through_the_wide_door) {
  const ByteImage rooms = image_of(kRooms);
  const auto crosses_at = [&](double width) {
    const auto path = find_path(rooms.view(), {{3, 1}, {11, 1}, width});
    for (const Pixel p : path.value().pixels) {
      if (p.x == 7) return p.y;
    }
    return -1;
  };
  EXPECT_EQ(crosses_at(0), 1);
  EXPECT_EQ(crosses_at(3), 5);
}

/// Of an obstacle's centre from a step between centres of pixels.
double distance_to_step(Pixel obstacle, Pixel from, Pixel to) {
  const double x = to.x - from.x, y = to.y - from.y;
  const double along = (obstacle.x - from.x) * x + (obstacle.y - from.y) * y;
  const double part = along == 0 ? 0 : std::clamp(along / (x * x + y * y), 0.0, 1.0);
  return std::hypot(obstacle.x - from.x - part * x, obstacle.y - from.y - part * y);
}

/// Paths by definition: every step is measured against every obstacle.
class PathsByDefinition {
 public:
  PathsByDefinition(const ByteImage& map, double width)
      : map_(map), width_(width), skeleton_(map.width(), map.height()) {
    thin(Rule::guo_hall, map.view(), skeleton_.view());
    std::vector<double> of_free(static_cast<std::size_t>(map.width() * map.height()));
    const View<double> distances_of_free(of_free.data(), map.width(), map.height());
    distances(map.view(), distances_of_free);
    prune(skeleton_.view(), skeleton_.view(), {.min_widths = 1, .distances = distances_of_free});
    for (std::int32_t y = 0; y < map.height(); ++y) {
      for (std::int32_t x = 0; x < map.width(); ++x) {
        (is_free({x, y}) ? free_ : obstacles_).push_back({x, y});
      }
    }
  }

  [[nodiscard]] const std::vector<Pixel>& free() const { return free_; }

  [[nodiscard]] double clearance(Pixel from, Pixel to) const {
    double min = std::numeric_limits<double>::infinity();
    for (const Pixel obstacle : obstacles_) {
      min = std::min(min, distance_to_step(obstacle, from, to));
    }
    return min;
  }

  /// Infinite where there is no such step.
  [[nodiscard]] double cost(Pixel from, Pixel to) const {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const bool is_step = length > 0 && length < 2 && is_free(from) && is_free(to);
    const bool slips = !is_free({to.x, from.y}) && !is_free({from.x, to.y});
    if (!is_step || slips || 2 * clearance(from, to) < width_ - 1e-9) {
      return std::numeric_limits<double>::infinity();
    }
    const bool on_skeleton = skeleton_.at(from.x, from.y) != 0 && skeleton_.at(to.x, to.y) != 0;
    return length * (on_skeleton ? 1 : kPathOffSkeletonCost);
  }

  /// By Bellman and Ford.
  [[nodiscard]] double lowest_cost(Pixel start, Pixel goal) const {
    std::vector<double> costs(free_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i] == start) costs[i] = 0;
    }
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t from = 0; from < free_.size(); ++from) {
        for (std::size_t to = 0; to < free_.size(); ++to) {
          const double reached = costs[from] + cost(free_[from], free_[to]);
          if (reached >= costs[to] - 1e-9) continue;
          costs[to] = reached;
          is_changed = true;
        }
      }
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i] == goal) return costs[i];
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  [[nodiscard]] bool is_free(Pixel p) const { return map_.at(p.x, p.y) != 0; }

  const ByteImage& map_;
  double width_;
  ByteImage skeleton_;
  std::vector<Pixel> free_, obstacles_;
};

/// Whether the path has steps alone, and the length and room that it says; gives its cost.
double checked_cost(const FoundPath& path, const PathsByDefinition& paths) {
  double cost = 0, length = 0;
  double min = paths.clearance(path.pixels.front(), path.pixels.front());
  for (std::size_t i = 1; i < path.pixels.size(); ++i) {
    const Pixel from = path.pixels[i - 1], to = path.pixels[i];
    cost += paths.cost(from, to);
    length += std::hypot(to.x - from.x, to.y - from.y);
    min = std::min(min, paths.clearance(from, to));
  }
  EXPECT_NEAR(path.length, length, 1e-9);
  if (std::isinf(min)) {
    EXPECT_EQ(path.min_width, min);
  } else {
    EXPECT_NEAR(path.min_width, 2 * min, 1e-9);
  }
  return cost;
}

/// Places without room are expected to be rejected.
void expect_lowest_cost(const ByteImage& map, Pixel start, Pixel goal, double width) {
  const PathsByDefinition paths(map, width);
  const double room = 2 * std::min(paths.clearance(start, start), paths.clearance(goal, goal));
  if (room < width) {
    EXPECT_THROW(static_cast<void>(find_path(map.view(), {start, goal, width})),
                 std::invalid_argument);
    return;
  }
  const auto path = find_path(map.view(), {start, goal, width});
  const double expected = paths.lowest_cost(start, goal);
  ASSERT_EQ(path.has_value(), std::isfinite(expected));
  if (path) {
    EXPECT_NEAR(checked_cost(*path, paths), expected, 1e-6);
  }
}

TEST(FindPath, has_the_lowest_cost_in_all_maps_of_4_x_4) {
  ByteImage map(4, 4);
  for (int number = 1; number < 1 << 16; ++number) {
    Pixel first = {-1, -1}, last = {};
    for (std::int32_t i = 0; i < 16; ++i) {
      const bool is_free = (number >> i & 1) != 0;
      map.at(i % 4, i / 4) = is_free ? 255 : 0;
      if (!is_free) continue;
      last = {i % 4, i / 4};
      if (first.x < 0) first = last;
    }
    const std::array<double, 3> widths = {0, 1.9, 2.5};
    expect_lowest_cost(map, first, last, widths[static_cast<std::size_t>(number % 3)]);
    ASSERT_FALSE(HasFailure()) << "map " << number;
  }
}

TEST(FindPath, has_the_lowest_cost_in_random_maps) {
  std::mt19937 random(1);
  for (int i = 0; i < 150; ++i) {
    ByteImage map(14, 11);
    const unsigned parts = 3 + static_cast<unsigned>(i) % 20;
    for (Index y = 0; y < 11; ++y) {
      for (Index x = 0; x < 14; ++x) map.at(x, y) = random() % parts == 0 ? 0 : 255;
    }
    map.at(0, 0) = map.at(13, 10) = 255;
    expect_lowest_cost(map, {0, 0}, {13, 10}, 0.5 * (i % 12));
    ASSERT_FALSE(HasFailure()) << "map " << i;
  }
}

TEST(FindPath, is_nothing_where_there_is_none) {
  EXPECT_FALSE(find_path(image_of(kRooms).view(), {{3, 4}, {11, 4}, 5}));
}

}  // namespace
}  // namespace thinbench
