// Measures of skeletons on shapes whose values are known.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/thinning_quality.hpp"

namespace thinbench {
namespace {

using Rows = std::vector<std::string>;

ByteImage image_of(const Rows& rows) {
  ByteImage image(static_cast<Index>(rows.front().size()), static_cast<Index>(rows.size()));
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      const bool dark = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
      image.at(x, y) = dark ? 255 : 0;
    }
  }
  return image;
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

TEST(SkeletonMeasures, axis_of_a_bar_is_its_middle_row_and_the_diagonals_at_its_ends) {
  ByteImage bar(40, 13);
  for (Index y = 1; y < 12; ++y) {
    for (Index x = 1; x < 39; ++x) bar.at(x, y) = 255;
  }
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
  ByteImage turned = quarter_turned(image.view());
  EXPECT_TRUE(equal(turned.view(), image_of({".#", ".#", "#."}).view()));
  for (int turn = 1; turn < 4; ++turn) turned = quarter_turned(turned.view());
  EXPECT_TRUE(equal(turned.view(), image.view()));
}

TEST(ThinningQuality, invariants_of_the_rules_show_on_scene_and_blobs) {
  for (const QualityRow& row : run_thinning_quality(quality_inputs({}))) {
    const bool kept =
        row.before.objects == row.after.objects && row.before.holes == row.after.holes;
    const bool claimed = row.operation == "thin_guo_hall" || row.operation == "thin_mb2" ||
                         row.operation == "thin_spta" || row.operation == "thin_spta_directional";
    EXPECT_TRUE(kept || !claimed) << row.operation << " on " << row.input;
    const bool symmetric = row.operation == "thin_mb2" || row.operation == "thin_naccache_shinghal";
    EXPECT_EQ(row.symmetry == 1, symmetric) << row.operation << " on " << row.input;
  }
}

TEST(ThinningQuality, file_holds_every_row_and_no_folder) {
  std::vector<QualityInput> inputs;
  inputs.push_back({"dot", image_of({"#"})});
  const auto rows = run_thinning_quality(inputs);
  const auto json = nlohmann::json::parse(thinning_quality_report(rows, " --image a.png").json);
  EXPECT_EQ(json.at("command"), "thinbench experiment quality --image a.png");
  EXPECT_EQ(json.at("rows").size(), rows.size());
  EXPECT_EQ(json.at("/rows/0/objects_after"_json_pointer), 1);
}

}  // namespace
}  // namespace thinbench
