// The measures of edges and the form of reports. results/experiments/ has every number of every
// experiment, and tests/experiments compares them.
#include "experiments/experiments.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/made_image.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

Json data_of(const ExperimentReport& report) {
  return Json::parse(report.json);
}

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
  const Json data = data_of(report);
  EXPECT_EQ(data.at("schema"), 1);
  EXPECT_EQ(data.at("experiment"), "some");
  EXPECT_EQ(data.at("command"), "thinbench-study experiment some --quick");
  EXPECT_EQ(data.at("/rows/1/sums/in_all"_json_pointer), 7);
}

}  // namespace
}  // namespace thinbench
