#include "images/occupancy_map.hpp"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/file_error.hpp"
#include "support/made_image.hpp"
#include "support/own_directory.hpp"
#include "support/rejection.hpp"

namespace thinbench {
namespace {

using OccupancyMapTest = OwnDirectory;

constexpr const char* kShort = "image: a.pgm\nresolution: 0.05\norigin: [-1, 2.5, 0]\n";

/// What reading a description of this text says.
std::string error_of(const std::string& text) {
  std::ofstream("map.yaml") << text;
  return rejection_of<FileError>([] { static_cast<void>(read_map_description("map.yaml")); });
}

/// The short description with this line in place of that of the same key.
std::string with(const std::string& line) {
  std::string text = kShort;
  const auto at = text.find(line.substr(0, line.find(':') + 1));
  if (at != std::string::npos) text.erase(at, text.find('\n', at) + 1 - at);
  return text + line + '\n';
}

FreeSpace space_of(std::vector<std::uint8_t> levels, const MapDescription& map,
                   bool unknown_is_free = false) {
  return free_space({levels.data(), static_cast<Index>(levels.size()), 1}, map, unknown_is_free);
}

std::vector<int> free_in(const FreeSpace& space) {
  const std::uint8_t* const row = space.image.view().row(0);
  return {row, row + space.image.width()};
}

bool is_map(const std::vector<int>& levels) {
  return is_occupancy_map(
      GreyImage(image_by(static_cast<Index>(levels.size()), 3,
                         [&](Index x, Index) { return levels[static_cast<std::size_t>(x)]; })));
}

TEST_F(OccupancyMapTest, description_has_all_its_keys_and_the_image_lies_beside_it) {
  put("maps/hall.yml",
      "image: sub/hall.png\nmode: trinary\nresolution: 0.1\norigin: [1.5, -2, 0.25]\nnegate: 1\n"
      "occupied_thresh: 0.7\nfree_thresh: 0.3\nother: [1, 2]\n");
  const MapDescription map = read_map_description("maps/hall.yml");
  EXPECT_EQ(map.image, "maps/sub/hall.png");
  EXPECT_EQ(map.resolution, 0.1);
  EXPECT_EQ(map.origin, (std::array{1.5, -2.0, 0.25}));
  EXPECT_TRUE(map.negate);
  EXPECT_EQ(map.occupied_thresh, 0.7);
  EXPECT_EQ(map.free_thresh, 0.3);
}

TEST_F(OccupancyMapTest, description_has_defaults) {
  put("map.yaml", kShort);
  const MapDescription map = read_map_description("map.yaml");
  EXPECT_EQ(map.image, "a.pgm");
  EXPECT_FALSE(map.negate);
  EXPECT_EQ(map.occupied_thresh, 0.65);
  EXPECT_EQ(map.free_thresh, 0.25);
  EXPECT_TRUE(is_map_description("a/B.YAML") && is_map_description("b.yml"));
  EXPECT_FALSE(is_map_description("yaml") || is_map_description("a.yaml.png"));
}

TEST_F(OccupancyMapTest, what_is_wrong_is_named_with_what_would_be_right) {
  const std::string wrong = "cannot read 'map.yaml': ";
  const std::string metres =
      wrong + "resolution: expected metres per pixel, a number above 0, got ";
  const std::string pose = wrong + "origin: expected [x, y, yaw], three numbers, got ";
  const std::string above = wrong + "occupied_thresh: expected a number above free_thresh, ";
  for (const auto& [line, error] : std::vector<std::pair<std::string, std::string>>{
           {"image:", wrong + "image: expected the name of an image file, got nothing"},
           {"image: {a: b}", wrong + "image: expected the name of an image file, got keys"},
           {"resolution: 0", metres + "'0'"},
           {"resolution: .inf", metres + "'.inf'"},
           {"resolution: 5 cm", metres + "'5 cm'"},
           {R"(resolution: "5\ncm")", metres + R"('5\x0acm')"},
           {"resolution:", metres + "nothing"},
           {"origin: [1, 2]", pose + "a list of 2 values"},
           {"origin: 5", pose + "'5'"},
           {"origin: [1, x, 0]", pose + "'x'"},
           {"negate: 2", wrong + "negate: expected 0 or 1, got '2'"},
           {"free_thresh: low", wrong + "free_thresh: expected a number, got 'low'"},
           {"free_thresh: 0.65", above + "0.65, got nothing"},
           {"occupied_thresh: 0.2", above + "0.25, got '0.2'"},
           {"mode: scale", wrong + "mode: expected trinary, got 'scale'"},
           {"a: [", wrong + "it is not YAML: line 5: end of sequence flow not found"}}) {
    EXPECT_EQ(error_of(with(line)), error);
  }
  EXPECT_EQ(error_of("free"), wrong + "it describes no map: it has no keys");
  EXPECT_NE(error_of(with("other: " + std::string(200'000, 'a'))), "");
}

TEST(FreeSpaceTest, is_what_lies_below_the_threshold) {
  const MapDescription map = {.occupied_thresh = 0.6, .free_thresh = 0.2};  // of 102 and 204
  const FreeSpace space = space_of({0, 101, 102, 204, 205, 255}, map);
  EXPECT_EQ(free_in(space), (std::vector{0, 0, 0, 0, 255, 255}));
  EXPECT_EQ(space.unknown, 2);
  EXPECT_EQ(free_in(space_of({0, 101, 102, 204, 205, 255}, map, true)),
            (std::vector{0, 0, 255, 255, 255, 255}));
}

TEST(FreeSpaceTest, dark_pixels_of_a_negated_map_are_free) {
  const FreeSpace space = space_of({0, 50, 51, 153, 154, 255},
                                   {.occupied_thresh = 0.6, .free_thresh = 0.2, .negate = true});
  EXPECT_EQ(free_in(space), (std::vector{255, 255, 0, 0, 0, 0}));
  EXPECT_EQ(space.unknown, 2);
}

TEST(FreeSpaceTest, level_of_unknown_that_is_free_gives_a_warning) {
  EXPECT_EQ(space_of({0, 205, 254}, {}).warning,
            "grey level 205, by which ROS marks what is unknown, is free; free_thresh is 0.25, and "
            "0.196 makes it unknown");
  EXPECT_EQ(space_of({0, 204, 254}, {}).warning, "");
  EXPECT_EQ(space_of({0, 205, 254}, {.free_thresh = 0.196}).warning, "");
  EXPECT_EQ(space_of({0, 205, 254}, {.free_thresh = 0.196}).unknown, 1);
}

TEST(OccupancyMap, is_an_image_of_three_levels) {
  EXPECT_TRUE(is_map({0, 205, 254}));
  EXPECT_TRUE(is_map({0, 205, 255}));
  EXPECT_TRUE(is_map({205, 254, 255}));
  EXPECT_FALSE(is_map({0, 254, 255}));
  EXPECT_FALSE(is_map({0, 205, 205}));
  EXPECT_FALSE(is_map({0, 205, 254, 204}));
}

TEST(MapPoints, are_centres_of_pixels_in_a_turned_frame) {
  const MapDescription map = {.resolution = 0.5, .origin = {10, 20, std::numbers::pi / 2}};
  const auto expect_point = [&map](Pixel pixel, double x, double y) {
    const MapPoint point = point_of(pixel, map, 4);
    EXPECT_NEAR(point.x, x, 1e-12);
    EXPECT_NEAR(point.y, y, 1e-12);
    EXPECT_EQ(pixel_at(point, map, 4), pixel);
    EXPECT_EQ(pixel_at({point.x - 0.24, point.y + 0.24}, map, 4), pixel);
    EXPECT_EQ(pixel_at({point.x - 0.26, point.y}, map, 4), (Pixel{pixel.x, pixel.y - 1}));
  };
  expect_point({0, 3}, 9.75, 20.25);
  expect_point({2, 1}, 8.75, 21.25);
}

TEST(MapPoints, outside_have_no_pixel) {
  const MapDescription map = {.resolution = 0.5};
  EXPECT_EQ(pixel_at({-0.1, 0.1}, map, 4), (Pixel{-1, 3}));
  EXPECT_EQ(pixel_at({0.1, -0.1}, map, 4), (Pixel{0, 4}));
  EXPECT_EQ(pixel_at({0.1, 2.1}, map, 4), (Pixel{0, -1}));
  EXPECT_EQ(pixel_at({1e300, 1e300}, map, 4), (Pixel{-1, 4}));
}

}  // namespace
}  // namespace thinbench
