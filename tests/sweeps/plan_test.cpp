#include "sweeps/plan.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace thinbench {
namespace {

std::vector<Point> points_of(const std::string& sweep, bool quick = false, int processors = 4) {
  return plan_points({{sweep}, "", quick, processors}, all_operations());
}

std::set<double> places(const std::vector<Point>& points) {
  std::set<double> found;
  for (const Point& point : points) found.insert(point.x);
  return found;
}

TEST(SweepPlan, sizes_reach_from_32_to_8192_and_awkward_ones_are_among_them) {
  const std::set<double> sides = places(points_of("size"));
  for (const double side : {32, 8192, 33, 63, 65, 100, 127, 511, 513, 1000, 1023, 1025}) {
    EXPECT_TRUE(sides.contains(side)) << side;
  }
  EXPECT_EQ(*sides.begin(), 32);
  EXPECT_EQ(*sides.rbegin(), 8192);
}

TEST(SweepPlan, every_size_has_the_fastest_and_a_scalar_row_of_each_operation) {
  const std::vector<Point> points = points_of("size");
  const auto of_guo_hall_at = [&](double side) {
    std::set<std::string> rows;
    for (const Point& point : points) {
      if (point.x == side && point.operation->name == "thin_guo_hall") rows.insert(point.row());
    }
    return rows;
  };
  const std::set<std::string> rows = of_guo_hall_at(513);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(*rows.begin(), "thin_guo_hall/bitpacked/baseline/1");
  EXPECT_TRUE(rows.rbegin()->starts_with("thin_guo_hall/simd_bitpacked")) << *rows.rbegin();
  EXPECT_EQ(rows.rbegin()->find("_row/"), std::string::npos) << "too wide for it";
}

TEST(SweepPlan, threads_reach_the_processors_and_not_above) {
  for (const int processors : {1, 2, 7, 64}) {
    const std::set<double> threads = places(points_of("threads", false, processors));
    EXPECT_EQ(*threads.begin(), 1);
    EXPECT_EQ(*threads.rbegin(), processors);
  }
  EXPECT_EQ(thread_steps(6), (std::vector{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(thread_steps(64), (std::vector{1, 2, 3, 4, 5, 6, 7, 8, 12, 18, 27, 40, 60, 64}));
}

TEST(SweepPlan, threads_are_compared_with_the_same_technique_on_one) {
  std::map<std::string, std::set<std::string_view>> techniques;
  for (const Point& point : points_of("threads")) {
    EXPECT_EQ(point.clock(), "wall");
    EXPECT_EQ(point.variant->threaded, point.threads > 1);
    techniques[point.operation->name].insert(point.variant->technique);
  }
  EXPECT_GE(techniques.size(), 5U);
  for (const auto& [operation, names] : techniques) EXPECT_EQ(names.size(), 1U) << operation;
}

TEST(SweepPlan, density_goes_from_none_to_all_and_grains_from_1_to_16_at_2048) {
  const std::vector<Point> points = points_of("density");
  EXPECT_EQ(*places(points).begin(), 0);
  EXPECT_EQ(*places(points).rbegin(), 100);
  std::set<double> grains;
  for (const Point& point : points) {
    grains.insert(*point.y);
    EXPECT_EQ(point.input.width, 2048);
    EXPECT_EQ(point.input.height, 2048);
  }
  EXPECT_EQ(*grains.begin(), 1);
  EXPECT_EQ(*grains.rbegin(), 16);
  EXPECT_EQ(points.size(), places(points).size() * grains.size() * 5);
}

TEST(SweepPlan, every_available_level_is_measured) {
  std::set<Isa> levels;
  for (const Point& point : points_of("isa")) levels.insert(point.variant->isa);
  for (const Isa isa : kAllIsas) EXPECT_EQ(levels.contains(isa), isa_available(isa));
}

TEST(SweepPlan, depths_double_up_to_512) {
  EXPECT_EQ(places(points_of("depth")), (std::set<double>{4, 8, 16, 32, 64, 128, 256, 512}));
}

TEST(SweepPlan, the_scene_is_enlarged_up_to_ten_times) {
  EXPECT_EQ(places(points_of("enlarged")), (std::set<double>{1, 2, 5, 10}));
  const SweepInput five{Picture::enlarged, 2550, 2060, 5};
  const ByteImage large = make_input(five, InputKind::binary);
  const ByteImage scene = make_input({Picture::scene, 510, 412}, InputKind::binary);
  for (const Index y : {0, 4, 5, 2059}) {
    for (Index x = 0; x < 2550; ++x) ASSERT_EQ(large.at(x, y), scene.at(x / 5, y / 5));
  }
}

TEST(SweepPlan, quick_plan_is_smaller_and_has_all_sweeps) {
  for (const SweepInfo& info : all_sweeps()) {
    const std::string name(info.name);
    EXPECT_FALSE(points_of(name, true).empty()) << name;
    EXPECT_LE(points_of(name, true).size(), points_of(name).size()) << name;
  }
}

TEST(SweepPlan, names_of_points_are_unique_and_filters_leave_what_they_match) {
  std::set<std::string> names;
  const std::vector<Point> all = plan_points({{}, "", false, 2}, all_operations());
  for (const Point& point : all) names.insert(point.name());
  EXPECT_EQ(names.size(), all.size());
  for (const Point& point : plan_points({{}, "^holes/", false, 2}, all_operations())) {
    EXPECT_EQ(point.operation->name, "holes");
  }
  EXPECT_THROW(static_cast<void>(plan_points({{}, "(", false, 2}, all_operations())),
               std::invalid_argument);
}

}  // namespace
}  // namespace thinbench
