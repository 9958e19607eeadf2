// The numbers here were computed from the paper before any code of this project.
#include "experiments/experiments.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/filled_image.hpp"
#include "support/made_image.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

Json data_of(const ExperimentReport& report) {
  return Json::parse(report.json);
}

/// The row whose field has this value, or whose text begins with it.
Json row_where(const Json& rows, const char* field, const std::string& value) {
  for (const Json& row : rows) {
    if (row.at(field).get<std::string>().starts_with(value)) return row;
  }
  throw std::out_of_range(value);
}

/// With so many fractional bits; the first half of the rows are rounded, the second truncated.
Json quantisation_row(Quantisation way, std::size_t bits) {
  static const Json rows = data_of(quantisation()).at("rows");
  return rows.at(way == Quantisation::round ? bits : rows.size() / 2 + bits);
}

TEST(Quantisation, of_table_1_keeps_so_many_decisions_and_one_fractional_bit_is_enough) {
  EXPECT_EQ(quantisation_row(Quantisation::round, 0).at("right_sigmoid"), 251);
  EXPECT_EQ(quantisation_row(Quantisation::round, 0).at("right_linear"), 252);
  EXPECT_EQ(quantisation_row(Quantisation::truncate, 0).at("right_sigmoid"), 254);
  EXPECT_EQ(quantisation_row(Quantisation::truncate, 0).at("right_linear"), 253);
  for (std::size_t bits = 1; bits <= 8; ++bits) {
    EXPECT_EQ(quantisation_row(Quantisation::round, bits).at("right_sigmoid"), 256) << bits;
    EXPECT_EQ(quantisation_row(Quantisation::round, bits).at("right_linear"), 256) << bits;
  }
}

TEST(Quantisation, largest_weight_fits_eight_bits_up_to_two_fractional_bits) {
  EXPECT_EQ(quantisation_row(Quantisation::round, 0).at("largest_integer"), 20);
  EXPECT_LE(quantisation_row(Quantisation::round, 2).at("largest_integer"), 127);
  EXPECT_GT(quantisation_row(Quantisation::round, 3).at("largest_integer"), 127);
}

TEST(HiddenNeurons, quick_run_learns_with_ten_but_not_with_two) {
  HiddenNeuronsChoice choice = HiddenNeuronsChoice::quick();
  choice.seeds = 2;
  int reports = 0;
  std::vector<Json> rows;
  for (const int hidden : {2, 10}) {
    choice.min_hidden = choice.max_hidden = hidden;
    rows.push_back(data_of(hidden_neurons(choice, [&](double) { ++reports; })));
  }
  EXPECT_EQ(rows[0].at("/rows/0/seeds_with_all_right"_json_pointer), 0);
  EXPECT_LT(rows[0].at("/rows/0/best"_json_pointer), 256);
  EXPECT_EQ(rows[0].at("fewest_that_reached_all"), 0);
  EXPECT_EQ(rows[1].at("/rows/0/seeds_with_all_right"_json_pointer), 2);
  EXPECT_EQ(rows[1].at("/rows/0/best"_json_pointer), 256);
  EXPECT_EQ(rows[1].at("fewest_that_reached_all"), 10);
  EXPECT_EQ(reports, 2);
}

TEST(ClusterRuns, rule_needs_the_papers_twelve_nets) {
  const Json data = data_of(cluster_runs());
  EXPECT_EQ(data.at("nets"), 12);
  EXPECT_EQ(data.at("rows").size(), 12U);
  EXPECT_EQ(data.at("/rows/0/first"_json_pointer), 0);
  EXPECT_EQ(data.at("/rows/11/last"_json_pointer), 255);
}

Json method(const std::string& beginning) {
  static const Json data = data_of(operation_counts());
  return row_where(data.at("methods"), "method", beginning);
}

TEST(OperationCounts, rule_takes_the_papers_40_logical_and_3_arithmetic_operations) {
  const Json sums = method("Naccache-Shinghal, four").at("sums");
  EXPECT_EQ(sums.at("logical"), 40);
  EXPECT_EQ(sums.at("arithmetic"), 3);
}

TEST(OperationCounts, two_layer_nets_take_more_than_150_arithmetic_operations) {
  for (const char* name : {"Two-layer net, sigmoid", "Two-layer net, linear"}) {
    const Json net = method(name);
    EXPECT_EQ(net.at("/sums/multiplications"_json_pointer), 72) << name;
    EXPECT_EQ(net.at("/sums/additions"_json_pointer), 72) << name;
    const int sums = net.at("/sums/arithmetic"_json_pointer);
    const int activations = net.at("/activations/arithmetic"_json_pointer);
    EXPECT_GT(sums + activations, 150) << name;
  }
}

TEST(OperationCounts, cluster_takes_the_papers_39_arithmetic_operations) {
  const Json sums = method("Cluster").at("sums");
  EXPECT_EQ(sums.at("powers"), 8);
  EXPECT_EQ(sums.at("multiplications"), 8 + 8);
  EXPECT_EQ(sums.at("additions"), 7 + 8);
  EXPECT_EQ(sums.at("arithmetic"), 39);
}

TEST(OperationCounts, circuit_has_at_most_eight_three_input_gates_and_serves_every_net) {
  const Json data = data_of(operation_counts());
  EXPECT_LE(data.at("/circuit/three_input/gates"_json_pointer), 8);
  EXPECT_EQ(data.at("/circuit/three_input/inverters"_json_pointer), 0);
  EXPECT_LE(data.at("/circuit/two_input/gates"_json_pointer), 14);
  EXPECT_EQ(data.at("nets").size(), 3U);
  for (const Json& net : data.at("nets")) EXPECT_EQ(net.at("compiles_to_the_rule"), true) << net;
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

TEST(EdgeQuality, recall_means_little_where_much_is_marked) {
  const ByteImage everything = filled_image(20, 10, 255);
  const TrueContours contours{image_with_column(5), image_with_column(5)};
  const EdgeQuality quality = quality_of(contours, everything.view());
  EXPECT_EQ(quality.recall, 1);
  EXPECT_EQ(quality.marked, 1);
  EXPECT_EQ(quality.precision, 0.15);
}

TEST(EdgeQuality, every_operator_finds_the_contours_of_the_clean_scene) {
  EdgeQualityChoice choice = EdgeQualityChoice::quick();
  choice.sigmas = {0};
  const Json rows = data_of(edge_quality(choice)).at("rows");
  EXPECT_EQ(rows.size(), 6U);
  for (const Json& row : rows) {
    EXPECT_GT(row.at("recall"), 0.95) << row;
    EXPECT_GT(row.at("precision"), 0.95) << row;
  }
}

TEST(LiteralHoles, are_right_on_one_object_with_walls_of_three_pixels_or_more) {
  const Json rows = data_of(literal_holes()).at("rows");
  ASSERT_EQ(rows.size(), 8U);
  for (std::size_t wall = 1; wall <= 5; ++wall) {
    const Json& row = rows[wall - 1];
    EXPECT_EQ(row.at("tried"), 41) << wall;
    EXPECT_EQ(row.at("right"), wall < 3 ? 1 : 41)
        << "behind thin walls no holes are seen: " << wall;
    EXPECT_EQ(row.at("rejected"), 0) << wall;
  }
}

TEST(LiteralHoles, take_other_objects_for_holes_and_reject_too_many_contours) {
  const Json rows = data_of(literal_holes()).at("rows");
  const Json& several = rows[5];
  EXPECT_EQ(several.at("tried"), 5 * 41);
  EXPECT_EQ(several.at("right"), 0);
  EXPECT_EQ(several.at("true_holes"), 0);
  EXPECT_EQ(several.at("counted"), 1) << "two plates without holes";
  const Json& scene = rows[6];
  EXPECT_EQ(scene.at("true_holes"), 47);
  EXPECT_EQ(scene.at("counted"), 47 + 21) << "22 objects";
  const Json& many = rows[7];
  EXPECT_EQ(many.at("true_holes"), 254);
  EXPECT_TRUE(many.at("counted").is_null());
  EXPECT_EQ(many.at("rejected"), 1);
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
