// The numbers here were computed from the paper before any code of this project.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/cluster_runs.hpp"
#include "experiments/edge_quality.hpp"
#include "experiments/hidden_neurons.hpp"
#include "experiments/literal_holes.hpp"
#include "experiments/operation_counts.hpp"
#include "experiments/quantisation.hpp"
#include "experiments/table_2.hpp"
#include "support/temporary_directory.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::json;

QuantisationRow quantisation_row(Quantisation way, int bits) {
  for (const QuantisationRow& row : run_quantisation()) {
    if (row.way == way && row.fractional_bits == bits) return row;
  }
  return {};
}

const OperationCount& method(const OperationCounts& counts, const std::string& beginning) {
  for (const OperationCount& count : counts.methods) {
    if (count.method.find(beginning) == 0) return count;
  }
  throw std::out_of_range(beginning);
}

TEST(Quantisation, integer_rounding_of_table_1_keeps_251_with_the_sigmoid_and_252_linear) {
  EXPECT_EQ(quantisation_row(Quantisation::round, 0).right_sigmoid, 251);
  EXPECT_EQ(quantisation_row(Quantisation::round, 0).right_linear, 252);
}

TEST(Quantisation, integer_truncation_of_table_1_keeps_254_with_the_sigmoid_and_253_linear) {
  EXPECT_EQ(quantisation_row(Quantisation::truncate, 0).right_sigmoid, 254);
  EXPECT_EQ(quantisation_row(Quantisation::truncate, 0).right_linear, 253);
}

TEST(Quantisation, one_fractional_bit_by_rounding_is_enough) {
  for (int bits = 1; bits <= 8; ++bits) {
    EXPECT_EQ(quantisation_row(Quantisation::round, bits).right_sigmoid, 256) << bits;
    EXPECT_EQ(quantisation_row(Quantisation::round, bits).right_linear, 256) << bits;
  }
}

TEST(Quantisation, largest_weight_fits_eight_bits_up_to_two_fractional_bits) {
  EXPECT_EQ(quantisation_row(Quantisation::round, 0).largest_integer, 20);
  EXPECT_LE(quantisation_row(Quantisation::round, 2).largest_integer, 127);
  EXPECT_GT(quantisation_row(Quantisation::round, 3).largest_integer, 127);
}

TEST(HiddenNeurons, quick_run_learns_with_ten_but_not_with_two) {
  HiddenNeuronsChoice choice = HiddenNeuronsChoice::quick();
  choice.seeds = 2;
  int reports = 0;
  std::vector<HiddenNeuronsRow> rows;
  for (const int hidden : {2, 10}) {
    choice.fewest = choice.most = hidden;
    rows.push_back(run_hidden_neurons(choice, [&](double) { ++reports; }).front());
  }
  EXPECT_EQ(rows[0].perfect, 0);
  EXPECT_LT(rows[0].best, 256);
  EXPECT_EQ(rows[1].perfect, 2);
  EXPECT_EQ(rows[1].best, 256);
  EXPECT_EQ(fewest_hidden_neurons(rows), 10);
  EXPECT_EQ(reports, 2);
}

TEST(ClusterRuns, rule_needs_the_papers_twelve_nets) {
  const std::vector<TrainedRun> runs = run_cluster_runs();
  ASSERT_EQ(runs.size(), 12U);
  EXPECT_EQ(runs.front().run.first, 0);
  EXPECT_EQ(runs.back().run.last, 255);
  const Json json = Json::parse(cluster_runs_report(runs).json);
  EXPECT_EQ(json.at("nets"), 12);
  EXPECT_EQ(json.at("rows").size(), 12U);
}

TEST(OperationCounts, rule_takes_the_papers_40_logical_and_3_arithmetic_operations) {
  const OperationCounts counts = run_operation_counts();
  const Tally& rule = method(counts, "Naccache-Shinghal, four").most;
  EXPECT_EQ(rule.sums.logical, 40);
  EXPECT_EQ(rule.sums.arithmetic(), 3);
}

TEST(OperationCounts, two_layer_nets_take_more_than_150_arithmetic_operations) {
  const OperationCounts counts = run_operation_counts();
  for (const char* name : {"Two-layer net, sigmoid", "Two-layer net, linear"}) {
    const Tally& net = method(counts, name).most;
    EXPECT_EQ(net.sums.multiplications, 72) << name;
    EXPECT_EQ(net.sums.additions, 72) << name;
    EXPECT_GT(net.sums.arithmetic() + net.activations.arithmetic(), 150) << name;
  }
}

TEST(OperationCounts, cluster_takes_the_papers_39_arithmetic_operations) {
  const OperationCounts counts = run_operation_counts();
  const Operations& cluster = method(counts, "Cluster").most.sums;
  EXPECT_EQ(cluster.powers, 8);
  EXPECT_EQ(cluster.multiplications, 8 + 8);
  EXPECT_EQ(cluster.additions, 7 + 8);
  EXPECT_EQ(cluster.arithmetic(), 39);
}

TEST(OperationCounts, circuit_has_at_most_eight_three_input_gates_and_serves_every_net) {
  const OperationCounts counts = run_operation_counts();
  EXPECT_LE(counts.circuit.three_input.gates, 8);
  EXPECT_EQ(counts.circuit.three_input.inverters, 0);
  EXPECT_LE(counts.circuit.two_input.gates, 14);
  for (const CompiledNet& net : counts.nets) EXPECT_TRUE(net.same_table) << net.net;
}

TEST(Table2, ratios_of_the_paper_are_those_of_its_seconds) {
  const std::vector<ThenAndNow> rows = then_and_now({});
  const std::vector<double> expected = {0.92, 0.42, 1, 7.0, 4.85, 1.22};
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i].then_ratio, expected[i], 0.005) << rows[i].paper.method;
    EXPECT_FALSE(rows[i].reference_ratio) << rows[i].paper.method;
  }
}

TEST(Table2, measured_times_are_set_against_naccache_shinghal_measured) {
  const MeasuredTimes net = {3000.0, 400.0, "lut (baseline)"};
  const auto rows = then_and_now(
      {{"thin_naccache_shinghal", {2000.0, 100.0, "any"}}, {"net_two_layer_linear", net}});
  EXPECT_EQ(rows[4].reference_ratio, 1.5);
  EXPECT_EQ(rows[4].best_ratio, 4.0);
  EXPECT_FALSE(rows[3].now.reference_ns);
  EXPECT_FALSE(then_and_now({{"net_two_layer_linear", net}})[4].reference_ratio);
  EXPECT_NE(table_2_report(rows).markdown.find(
                "| 3.54 | 4.85 | 3.0 | 1.50 | lut (baseline) | 0.4 | 4.00 |"),
            std::string::npos);
}

TEST(Table2, times_with_a_kept_border_or_a_limit_are_another_matter) {
  const TemporaryDirectory folder;
  std::ofstream(folder.file("timings.csv"))
      << "operation,technique,isa,threads,scope,input,median_ns,border,max_iterations\n"
         "thin_guo_hall,lut,baseline,1,end_to_end,scene,200,background,\n"
         "thin_guo_hall,lut,baseline,1,end_to_end,scene,100,keep,\n"
         "thin_guo_hall,lut,baseline,1,end_to_end,scene,10,background,1\n"
         "holes,lut,baseline,1,end_to_end,scene,50,,\n";
  const TimesByOperation times = read_measured_times(folder.path().string());
  EXPECT_EQ(times.at("thin_guo_hall").best_ns, 200);
  EXPECT_EQ(times.at("holes").best_ns, 50);
}

ByteImage image_with_column(Index column) {
  ByteImage image(20, 10);
  for (Index y = 0; y < 10; ++y) image.at(column, y) = 255;
  return image;
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
  const EdgeQuality same = edge_quality(contours, contours.inner.view());
  EXPECT_EQ(same.precision, 1);
  EXPECT_EQ(same.recall, 1);
  EXPECT_EQ(same.figure_of_merit, 1);
  const EdgeQuality beside = edge_quality(contours, image_with_column(6).view());
  EXPECT_EQ(beside.precision, 1);
  EXPECT_NEAR(beside.figure_of_merit, 0.9, 1e-12);
  const EdgeQuality apart = edge_quality(contours, image_with_column(8).view());
  EXPECT_EQ(apart.precision, 0);
  EXPECT_EQ(apart.recall, 0);
  EXPECT_NEAR(apart.figure_of_merit, 0.5, 1e-12);
}

TEST(EdgeQuality, merit_is_measured_against_a_contour_one_pixel_wide) {
  ByteImage both = image_with_column(5);
  for (Index y = 0; y < 10; ++y) both.at(6, y) = 255;
  const TrueContours contours{copy_of(both.view()), image_with_column(5)};
  const EdgeQuality thin = edge_quality(contours, image_with_column(5).view());
  EXPECT_EQ(thin.figure_of_merit, 1);
  EXPECT_EQ(thin.marked, 0.05);
  const EdgeQuality thick = edge_quality(contours, both.view());
  EXPECT_NEAR(thick.figure_of_merit, 0.95, 1e-12) << "half of its pixels are one pixel away";
  EXPECT_EQ(thick.marked, 0.1);
}

TEST(EdgeQuality, recall_means_little_where_much_is_marked) {
  ByteImage everything(20, 10);
  for (Index y = 0; y < 10; ++y) {
    for (Index x = 0; x < 20; ++x) everything.at(x, y) = 255;
  }
  const TrueContours contours{image_with_column(5), image_with_column(5)};
  const EdgeQuality quality = edge_quality(contours, everything.view());
  EXPECT_EQ(quality.recall, 1);
  EXPECT_EQ(quality.marked, 1);
  EXPECT_EQ(quality.precision, 0.15);
}

TEST(EdgeQuality, every_operator_finds_the_contours_of_the_clean_scene) {
  EdgeQualityChoice choice = EdgeQualityChoice::quick();
  choice.sigmas = {0};
  const auto rows = run_edge_quality(choice);
  EXPECT_EQ(rows.size(), 6U);
  for (const EdgeQualityRow& row : rows) {
    EXPECT_GT(row.quality.recall, 0.95) << row.operation;
    EXPECT_GT(row.quality.precision, 0.95) << row.operation;
  }
}

TEST(LiteralHoles, are_right_on_one_object_with_walls_of_three_pixels_or_more) {
  const std::vector<LiteralHolesRow> rows = run_literal_holes();
  ASSERT_EQ(rows.size(), 8U);
  for (std::size_t wall = 1; wall <= 5; ++wall) {
    const LiteralHolesRow& row = rows[wall - 1];
    EXPECT_EQ(row.tried, 41) << wall;
    EXPECT_EQ(row.right, wall < 3 ? 1 : 41) << "behind thin walls no holes are seen: " << wall;
    EXPECT_EQ(row.refused, 0) << wall;
  }
}

TEST(LiteralHoles, take_other_objects_for_holes_and_refuse_too_many_contours) {
  const std::vector<LiteralHolesRow> rows = run_literal_holes();
  const LiteralHolesRow& several = rows[5];
  EXPECT_EQ(several.tried, 5 * 41);
  EXPECT_EQ(several.right, 0);
  EXPECT_EQ(several.true_holes, 0);
  EXPECT_EQ(several.counted, 1) << "two plates without holes";
  const LiteralHolesRow& scene = rows[6];
  EXPECT_EQ(scene.true_holes, 47);
  EXPECT_EQ(scene.counted, 47 + 21) << "22 objects";
  const LiteralHolesRow& many = rows[7];
  EXPECT_EQ(many.true_holes, 254);
  EXPECT_EQ(many.counted, std::nullopt);
  EXPECT_EQ(many.refused, 1);
}

TEST(ExperimentReports, every_file_names_its_schema_experiment_and_command) {
  const std::vector<std::pair<std::string, ExperimentReport>> reports = {
      {"edge-quality", edge_quality_report({{"edges_sobel", 8, {1, 1, 0.5, 0.1}, 0.9}}, {})},
      {"literal-holes", literal_holes_report({{"some", 2, 1, 1, 5, {}}})},
      {"quantisation", quantisation_report(run_quantisation())},
      {"operation-counts", operation_counts_report(run_operation_counts())},
      {"table-2", table_2_report(then_and_now({}))},
      {"hidden-neurons", hidden_neurons_report({{8, 1, 256, 256, 1, 200}}, {})}};
  for (const auto& [name, report] : reports) {
    const Json json = Json::parse(report.json);
    EXPECT_EQ(json.at("schema"), 1) << name;
    EXPECT_EQ(json.at("experiment"), name);
    EXPECT_EQ(json.at("command"), "thinbench experiment " + name);
  }
}

TEST(ExperimentReports, numbers_of_the_tables_stand_in_the_files) {
  const Json counts = Json::parse(operation_counts_report(run_operation_counts()).json);
  EXPECT_EQ(counts.at("/methods/0/sums/logical"_json_pointer), 40);
  EXPECT_EQ(counts.at("/methods/4/sums/arithmetic"_json_pointer), 39);
  const Json quantisation = Json::parse(quantisation_report(run_quantisation()).json);
  EXPECT_EQ(quantisation.at("/as_published/right_linear"_json_pointer), 256);
  EXPECT_EQ(quantisation.at("/rows/0/right_sigmoid"_json_pointer), 251);
  const Json hidden = Json::parse(
      hidden_neurons_report({{7, 9, 250, 240, 0, 0}, {8, 9, 256, 256, 5, 200}}, {}).json);
  EXPECT_EQ(hidden.at("fewest_that_reached_all"), 8);
}

}  // namespace
}  // namespace thinbench
