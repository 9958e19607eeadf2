// Measures of edges and of skeletons, and the form of reports. results/experiments/ has every
// number of every experiment, and tests/experiments compares them.
#include "experiments/experiments.hpp"

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/skeleton_measures.hpp"
#include "experiments/thinning_quality.hpp"
#include "harness/operation.hpp"
#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "reference.hpp"
#include "support/made_image.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

ByteImage image_with_column(Index column) {
  return image_by(20, 10, [=](Index x, Index) { return x == column ? 255 : 0; });
}

TEST(EdgeQuality, contours_are_both_sides_of_a_border_or_the_inner_one) {
  ByteImage half(6, 3);
  for (Index y = 0; y < 3; ++y) half.at(4, y) = half.at(5, y) = 255;
  const TrueContours contours = true_contours(half.view());
  for (Index x = 0; x < 6; ++x) {
    EXPECT_EQ(contours.both_sides.at(x, 1), x == 3 || x == 4 ? 255 : 0) << x;
    EXPECT_EQ(contours.inner.at(x, 1), x == 4 ? 255 : 0) << x;
  }
}

TEST(EdgeQuality, distance_of_one_pixel_is_right_but_costs_a_tenth_of_the_merit) {
  const TrueContours contours{image_with_column(5), image_with_column(5)};
  const EdgeQuality same = quality_of(contours, contours.inner.view());
  EXPECT_EQ(same.precision, 1);
  EXPECT_EQ(same.recall, 1);
  EXPECT_EQ(same.figure_of_merit, 1);
  const EdgeQuality beside = quality_of(contours, image_with_column(6).view());
  EXPECT_EQ(beside.precision, 1);
  EXPECT_NEAR(beside.figure_of_merit, 0.9, 1e-12);
  const EdgeQuality apart = quality_of(contours, image_with_column(8).view());
  EXPECT_EQ(apart.precision, 0);
  EXPECT_EQ(apart.recall, 0);
  EXPECT_NEAR(apart.figure_of_merit, 0.5, 1e-12);
}

TEST(EdgeQuality, merit_is_measured_against_a_contour_one_pixel_wide) {
  ByteImage both = image_with_column(5);
  for (Index y = 0; y < 10; ++y) both.at(6, y) = 255;
  const TrueContours contours{copy_of(both.view()), image_with_column(5)};
  const EdgeQuality thin = quality_of(contours, image_with_column(5).view());
  EXPECT_EQ(thin.figure_of_merit, 1);
  EXPECT_EQ(thin.marked, 0.05);
  const EdgeQuality thick = quality_of(contours, both.view());
  EXPECT_NEAR(thick.figure_of_merit, 0.95, 1e-12) << "half of its pixels are one pixel away";
  EXPECT_EQ(thick.marked, 0.1);
}

TEST(ExperimentReport, tables_hold_the_fields_of_the_rows_that_have_values) {
  const ExperimentReport report = report_of(
      "some", "A caption:",
      {{"seeds", 3},
       {"rows",
        {{{"name", "a"}, {"border", ""}, {"sums", {{"in_all", 0.5}}}, {"equal", true}},
         {{"name", "b"}, {"border", nullptr}, {"sums", {{"in_all", 7}}}, {"equal", false}}}}},
      " --quick");
  EXPECT_EQ(report.markdown,
            "A caption:\n\n| name | sums in all | equal |\n| --- | --- | --- |\n"
            "| a | 0.5 | yes |\n| b | 7 | no |\n");
  const Json data = Json::parse(report.json);
  EXPECT_EQ(data.at("schema"), 1);
  EXPECT_EQ(data.at("experiment"), "some");
  EXPECT_EQ(data.at("command"), "thinbench-study experiment some --quick");
  EXPECT_EQ(data.at("/rows/1/sums/in_all"_json_pointer), 7);
}

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

/// 255 where no pixel up to three rows and columns away is further from background by 0.8 per pixel
/// of way; all outside is background.
ByteImage axis_by_definition(const ByteImage& image) {
  constexpr Index margin = 7;
  const ByteImage padded =
      image_by(image.width() + 2 * margin, image.height() + 2 * margin, [&](Index x, Index y) {
        const Index u = x - margin, v = y - margin;
        const bool inside = u >= 0 && v >= 0 && u < image.width() && v < image.height();
        return inside ? image.at(u, v) : 0;
      });
  std::vector<std::int32_t> squares(static_cast<std::size_t>(padded.width() * padded.height()));
  const LabelView view = {squares.data(), padded.width(), padded.height()};
  reference::squared_distances(padded.view(), view);
  const auto distance = [&](Index x, Index y) {
    return std::sqrt(static_cast<double>(view.row(y + margin)[x + margin]));
  };
  return image_by(image.width(), image.height(), [&](Index x, Index y) {
    bool steep = image.at(x, y) == 0;
    for (Index dy = -3; dy <= 3; ++dy) {
      for (Index dx = -3; dx <= 3; ++dx) {
        const double way = std::hypot(dx, dy);
        steep = steep || (way > 0 && distance(x + dx, y + dy) - distance(x, y) >= 0.8 * way);
      }
    }
    return steep ? 0 : 255;
  });
}

TEST(SkeletonMeasures, axis_is_where_the_distance_to_background_and_to_the_outside_rises_nowhere) {
  std::uint64_t seed = 950;
  for (const int percent : {60, 90, 100}) {
    const ByteImage image = noise_image(19, 14, percent, 4, ++seed);
    EXPECT_TRUE(equal(medial_axis_of(image.view()).view(), axis_by_definition(image).view()))
        << percent;
  }
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

ByteImage turned(const ConstImageView& image, int quarters) {
  ByteImage result = copy_of(image);
  for (int turn = 0; turn < quarters; ++turn) result = rotated_by_quarter(result.view());
  return result;
}

TEST(SkeletonMeasures, four_quarter_turns_are_none) {
  const ByteImage image = image_of({"#..", ".##"});
  EXPECT_TRUE(equal(turned(image.view(), 1).view(), image_of({".#", ".#", "#."}).view()));
  EXPECT_TRUE(equal(turned(image.view(), 4).view(), image.view()));
}

Json rows_of(const std::vector<QualityInput>& inputs) {
  return Json::parse(thinning_quality(inputs).json).at("rows");
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

TEST(ThinningQuality,
     pictures_get_names_unlike_each_other_the_scene_the_blobs_and_files_of_skeletons) {
  EXPECT_EQ(names_from({"scene_thin_mb2.png", "thin_mb2.png", "a/thin_mb2.png", "blobs.png"}),
            (std::vector<std::string>{"scene", "blobs", "scene_thin_mb2_image", "thin_mb2",
                                      "thin_mb2_2", "blobs_image"}));
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
  for (const Json& row : rows_of(inputs)) {
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
