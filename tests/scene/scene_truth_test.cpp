#include "scene/scene_truth.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "holes.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

constexpr SceneKind kKinds[] = {SceneKind::parts, SceneKind::border_touching};

Scene render_clean(SceneKind kind) {
  return render_scene({.kind = kind, .noise_sigma_16 = 0, .illumination = false});
}

double centre_distance(const Region& found, ScenePoint truth) {
  return std::hypot(found.centre_x() - truth.x, found.centre_y() - truth.y);
}

/// Both lists are in raster order, so equal indices mean the same hole. Areas may differ by 2 % and
/// by `rounding` times the side of a square of the area, as small holes have whole pixels.
void expect_holes_agree(const Scene& scene, double centre_tolerance, double rounding = 0.25) {
  const std::vector<Region> found = reference::holes(scene.binary.view()).holes;
  ASSERT_EQ(found.size(), scene.holes.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const SceneHole& truth = scene.holes[i];
    EXPECT_EQ(static_cast<int>(found[i].enclosing_object), truth.part) << "hole " << truth.id;
    EXPECT_LT(centre_distance(found[i], truth.centre), centre_tolerance) << "hole " << truth.id;
    EXPECT_NEAR(static_cast<double>(found[i].area), truth.area,
                0.02 * truth.area + rounding * std::sqrt(truth.area))
        << "hole " << truth.id;
  }
}

/// `area_tolerance` is a fraction of the area, `centre_tolerance` a distance in pixels.
void expect_parts_agree(const Scene& scene, double area_tolerance, double centre_tolerance) {
  const std::vector<Region> found = reference::holes(scene.binary.view()).objects;
  ASSERT_EQ(found.size(), scene.parts.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const ScenePart& truth = scene.parts[i];
    if (truth.cut_by_border) continue;
    EXPECT_NEAR(static_cast<double>(found[i].area), truth.area, area_tolerance * truth.area)
        << "part " << truth.id;
    EXPECT_LT(centre_distance(found[i], truth.centre), centre_tolerance) << "part " << truth.id;
  }
}

TEST(SceneTruth, clean_image_agrees_with_the_truth) {
  for (const SceneKind kind : kKinds) {
    const Scene scene = render_clean(kind);
    expect_holes_agree(scene, 0.25);
    expect_parts_agree(scene, 0.02, 0.25);
  }
}

TEST(SceneTruth, noisy_image_agrees_with_the_truth) {
  for (const SceneKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Scene scene = render_scene({.kind = kind, .seed = seed});
      expect_holes_agree(scene, 0.5, 0.5);
      expect_parts_agree(scene, 0.03, 0.5);
    }
  }
}

TEST(SceneTruth, scaled_image_agrees_with_the_truth) {
  const Scene scene = render_scene({.scale = 4, .noise_sigma_16 = 0, .illumination = false});
  EXPECT_EQ(scene.grey.width(), 2040);
  EXPECT_EQ(scene.grey.height(), 1648);
  // At this scale edges fall between pixels: errors of up to half a pixel along each axis.
  expect_holes_agree(scene, 0.71);
  expect_parts_agree(scene, 0.01, 0.71);
}

TEST(SceneTruth, holes_are_inside_the_box_of_their_part) {
  const Scene scene = render_scene();
  for (const SceneHole& hole : scene.holes) {
    const SceneBox& box = scene.parts[static_cast<std::size_t>(hole.part) - 1].box;
    EXPECT_GT(hole.centre.x, box.x_min);
    EXPECT_LT(hole.centre.x, box.x_max);
    EXPECT_GT(hole.centre.y, box.y_min);
    EXPECT_LT(hole.centre.y, box.y_max);
  }
}

TEST(SceneTruth, json_lists_every_part_and_hole) {
  const Scene scene = render_scene({.kind = SceneKind::border_touching});
  const auto json = nlohmann::json::parse(scene_truth_json(scene));
  EXPECT_EQ(json.at("width"), 510);
  EXPECT_EQ(json.at("height"), 412);
  EXPECT_EQ(json.at("threshold"), scene.threshold);
  EXPECT_TRUE(json.at("convention").is_string());
  EXPECT_EQ(json.at("parts").size(), scene.parts.size());
  EXPECT_EQ(json.at("holes").size(), scene.holes.size());
  EXPECT_DOUBLE_EQ(json.at("holes")[0].at("area").get<double>(), scene.holes[0].area);
}

TEST(SceneTruth, cut_parts_have_no_area_and_a_box_inside_the_image) {
  const Scene scene = render_scene({.kind = SceneKind::border_touching});
  const auto json = nlohmann::json::parse(scene_truth_json(scene));
  int cut = 0;
  for (const auto& part : json.at("parts")) {
    if (!part.at("cut_by_border").get<bool>()) continue;
    ++cut;
    EXPECT_TRUE(part.at("area").is_null());
    EXPECT_GE(part.at("box").at("x_min").get<double>(), -0.5);
    EXPECT_LE(part.at("box").at("y_max").get<double>(), 411.5);
  }
  EXPECT_GE(cut, 6);
}

}  // namespace
}  // namespace thinbench
