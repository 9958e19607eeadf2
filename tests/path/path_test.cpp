#include "thinbench/path.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "support/rejection.hpp"
#include "support/text_image.hpp"
#include "thinbench/distance.hpp"

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

TEST(FindPath, goes_along_a_corridor) {
  const ByteImage corridor = image_of({".........",  //
                                       "#########",  //
                                       "........."});
  const FoundPath path = find_path(corridor.view(), {{0, 1}, {8, 1}}).value();
  EXPECT_EQ(path.pixels.size(), 9U);
  EXPECT_DOUBLE_EQ(path.length, 8);
  EXPECT_DOUBLE_EQ(path.min_width, 2);
}

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

TEST(FindPath, is_connected_has_the_room_and_the_length_that_it_says) {
  std::mt19937 random(1);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    ByteImage map(40, 30);
    for (Index y = 0; y < 30; ++y) {
      for (Index x = 0; x < 40; ++x) map.at(x, y) = random() % 16 == 0 ? 0 : 255;
    }
    map.at(0, 0) = map.at(39, 29) = 255;
    const double width = i % 4;
    try {
      const auto path_or_none = find_path(map.view(), {{0, 0}, {39, 29}, width});
      if (!path_or_none) continue;
      const FoundPath& path = *path_or_none;
      std::vector<double> rooms(40 * 30);
      distances(map.view(), {rooms.data(), 40, 30});
      double length = 0;
      double narrowest = std::numeric_limits<double>::infinity();
      for (std::size_t p = 0; p < path.pixels.size(); ++p) {
        const auto [x, y] = path.pixels[p];
        const double room = 2 * rooms[static_cast<std::size_t>(y * 40 + x)];
        ASSERT_GE(room, std::max(width, 2.0));
        narrowest = std::min(narrowest, room);
        if (p == 0) continue;
        const int across = std::abs(x - path.pixels[p - 1].x);
        const int down = std::abs(y - path.pixels[p - 1].y);
        ASSERT_TRUE(std::max(across, down) == 1);
        length += std::hypot(across, down);
      }
      ASSERT_NEAR(path.length, length, 1e-9);
      ASSERT_EQ(path.min_width, narrowest);
      ++found;
    } catch (const std::invalid_argument& error) {
      ASSERT_GT(width, 2) << error.what();
    }
  }
  EXPECT_GT(found, 100);
}

TEST(FindPath, is_nothing_where_there_is_none) {
  EXPECT_FALSE(find_path(image_of(kRooms).view(), {{3, 4}, {11, 4}, 5}));
  EXPECT_FALSE(find_path(image_of({"#.#"}).view(), {{0, 0}, {2, 0}, 1}));
}

TEST(FindPath, rejects_places_without_room_with_the_reason) {
  const ByteImage rooms = image_of(kRooms);
  const auto rejected = [&](const PathRequest& request) {
    return rejection_of([&] { static_cast<void>(find_path(rooms.view(), request)); });
  };
  EXPECT_EQ(rejected({{15, 0}, {0, 0}}),
            "start: row 0, column 15 is outside the map of 15 x 8 pixels");
  EXPECT_EQ(rejected({{0, 0}, {7, 0}}), "goal: row 0, column 7 is inside an obstacle");
  EXPECT_EQ(rejected({{6, 0}, {0, 0}, 3}),
            "start: at row 0, column 6 there is room for a width of 2, not of 3");
  EXPECT_EQ(rejected({{0, 0}, {0, 0}, -1}), "width: expected a finite number from 0 up, got -1");
  EXPECT_EQ(rejected({{0, 0}, {0, 0}, std::numeric_limits<double>::infinity()}),
            "width: expected a finite number from 0 up, got inf");
  const ConstImageView negative = {rooms.view().data, -1, 8, 15};
  EXPECT_EQ(rejection_of([&] { static_cast<void>(find_path(negative, {})); }),
            "source has the size -1 x 8");
}

}  // namespace
}  // namespace thinbench
