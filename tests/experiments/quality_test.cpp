// Measures of skeletons on shapes whose values are known.
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/thinning_quality.hpp"
#include "harness/operation.hpp"
#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "support/made_image.hpp"
#include "support/temporary_directory.hpp"
#include "support/text_image.hpp"

namespace thinbench {
namespace {

TEST(SkeletonMeasures, objects_join_at_corners_and_holes_do_not) {
  const ByteImage image = image_of({"##..###", "#.#.#.#", "....###", "#......"});
  const Topology found = topology_of(image.view());
  EXPECT_EQ(found.objects, 3);
  EXPECT_EQ(found.holes, 1);
  EXPECT_EQ(topology_of(image_of({"#.#", "..."}).view()).holes, 0) << "open to the frame";
}

TEST(SkeletonMeasures, ends_branches_and_blocks_are_counted) {
  const SkeletonShape cross = shape_of(image_of({"..#..", "..#..", "#####", "..#.."}).view());
  EXPECT_EQ(cross.pixels, 8);
  EXPECT_EQ(cross.ends, 3) << "the stub below touches three pixels of the bar";
  EXPECT_EQ(cross.branches, 1);
  EXPECT_EQ(cross.blocks, 0);
  EXPECT_EQ(shape_of(image_of({"###", "###"}).view()).blocks, 2);
}

TEST(SkeletonMeasures, axis_of_a_bar_is_its_middle_row_and_the_diagonals_at_its_ends) {
  const ByteImage bar = image_by(
      40, 13, [](Index x, Index y) { return x > 0 && x < 39 && y > 0 && y < 12 ? 255 : 0; });
  const ByteImage axis = medial_axis_of(bar.view());
  for (Index y = 1; y < 12; ++y) EXPECT_EQ(axis.at(20, y) != 0, y == 6) << y;
  for (Index i = 1; i < 6; ++i) EXPECT_NE(axis.at(i, i), 0) << i;
}

TEST(SkeletonMeasures, distance_is_from_the_nearest_pixel_of_the_axis) {
  const ByteImage axis = image_of({"....", "####", "....", "...."});
  const ByteImage line = image_of({"....", "##..", "....", "..##"});
  const AxisDistance found = distance_from(axis.view(), line.view());
  EXPECT_EQ(found.mean, 1);
  EXPECT_EQ(found.largest, 2);
}

TEST(SkeletonMeasures, overlap_is_both_over_either) {
  const ByteImage a = image_of({"##.", "..."});
  EXPECT_EQ(overlap(a.view(), image_of({".##", "..."}).view()), 1.0 / 3);
  EXPECT_EQ(overlap(a.view(), a.view()), 1);
  const ByteImage none(3, 2);
  EXPECT_EQ(overlap(none.view(), none.view()), 1);
}

TEST(SkeletonMeasures, four_quarter_turns_are_none) {
  const ByteImage image = image_of({"#..", ".##"});
  ByteImage turned = rotated_by_quarter(image.view());
  EXPECT_TRUE(equal(turned.view(), image_of({".#", ".#", "#."}).view()));
  for (int turn = 1; turn < 4; ++turn) turned = rotated_by_quarter(turned.view());
  EXPECT_TRUE(equal(turned.view(), image.view()));
}

nlohmann::json rows_of(const std::vector<QualityInput>& inputs) {
  return nlohmann::json::parse(thinning_quality(inputs).json).at("rows");
}

std::vector<std::string> names_from(const std::vector<std::string>& files) {
  const TemporaryDirectory directory;
  std::vector<std::string> images;
  for (const std::string& file : files) {
    images.push_back(directory.file(file));
    std::filesystem::create_directories(std::filesystem::path(images.back()).parent_path());
    write_grey(images.back(), noise_image(9, 9, 50, 1, 1).view());
  }
  std::vector<std::string> names;
  for (const QualityInput& input : quality_inputs(images)) names.push_back(input.name);
  return names;
}

TEST(ThinningQuality, pictures_get_names_unlike_each_other_the_scene_and_the_blobs) {
  EXPECT_EQ(names_from({"horse.png", "a/horse.png", "scene.png", "blobs.png", "b/blobs.png"}),
            (std::vector<std::string>{"scene", "blobs", "horse", "horse_2", "scene_image",
                                      "blobs_image", "blobs_image_2"}));
}

TEST(ThinningQuality, pictures_never_get_the_name_of_the_file_of_a_skeleton) {
  EXPECT_EQ(names_from({"scene_thin_mb2.png", "x_skeleton_scan.png", "thin_mb2.png"}),
            (std::vector<std::string>{"scene", "blobs", "scene_thin_mb2_image",
                                      "x_skeleton_scan_image", "thin_mb2"}));
}

ByteImage turned(const ConstImageView& image, int quarters) {
  ByteImage result = copy_of(image);
  for (int turn = 0; turn < quarters; ++turn) result = rotated_by_quarter(result.view());
  return result;
}

/// The overlap of the skeleton with that of the image turned by so many quarters.
double overlap_turned(const std::string& operation, const ConstImageView& image, int quarters) {
  const ByteImage skeleton = expected_of(operation, image).image;
  const ByteImage other = expected_of(operation, turned(image, quarters).view()).image;
  return overlap(skeleton.view(), turned(other.view(), 4 - quarters).view());
}

TEST(ThinningQuality, min_symmetry_is_the_smallest_overlap_of_three_turns) {
  std::vector<QualityInput> inputs;
  inputs.push_back({"noise", noise_image(40, 30, 80, 4, 3)});
  std::set<int> least_at;
  for (const nlohmann::json& row : rows_of(inputs)) {
    std::map<double, int> turns;
    for (const int quarters : {1, 2, 3}) {
      turns.emplace(overlap_turned(row.at("operation"), inputs[0].image.view(), quarters),
                    quarters);
    }
    EXPECT_EQ(row.at("min_symmetry"), turns.begin()->first) << row;
    least_at.insert(turns.begin()->second);
  }
  EXPECT_GT(least_at.size(), 1U) << "the same turn for every operation would prove little";
}

}  // namespace
}  // namespace thinbench
