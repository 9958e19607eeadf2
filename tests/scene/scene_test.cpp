// The scene, and what is known to be true of it.
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "holes.hpp"
#include "scene/scene_truth.hpp"
#include "support/fnv1a.hpp"
#include "support/property_images.hpp"

namespace thinbench {
namespace {

constexpr SceneKind kKinds[] = {SceneKind::parts, SceneKind::border_touching};

std::uint64_t hash_of_grey(SceneKind kind) {
  Fnv1a hash;
  hash.add_pixels(render_scene({.kind = kind}).grey.view());
  return hash.value();
}

// Recorded from builds by g++ 12 and clang++ 14, with -O0 and -O3, which agreed.
TEST(Scene, grey_bytes_are_the_same_on_every_machine) {
  EXPECT_EQ(hash_of_grey(SceneKind::parts), 0x6F01900C1697FEB3u);
  EXPECT_EQ(hash_of_grey(SceneKind::border_touching), 0x731ED37726D961B4u);
}

TEST(Scene, another_seed_changes_the_noise) {
  EXPECT_FALSE(equal(render_scene().grey.view(), render_scene({.seed = 2000}).grey.view()));
}

TEST(Scene, binary_image_is_the_thresholded_grey_image) {
  const Scene scene = render_scene();
  EXPECT_EQ(scene.grey.width(), 510);
  EXPECT_EQ(scene.grey.height(), 412);
  for (Index y = 0; y < 412; ++y) {
    for (Index x = 0; x < 510; ++x) {
      ASSERT_EQ(scene.binary.at(x, y), scene.grey.at(x, y) < scene.threshold ? 255 : 0);
    }
  }
}

TEST(Scene, strong_noise_adds_no_object_and_no_hole) {
  for (const SceneKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Scene scene = render_scene({.kind = kind, .noise_sigma_16 = 160, .seed = seed});
      EXPECT_EQ(region_counts(scene.binary),
                (RegionCounts{scene.parts.size(), scene.holes.size()}));
    }
  }
}

TEST(Scene, parts_touch_all_sides_of_the_image_in_one_kind_and_none_in_the_other) {
  for (const SceneKind kind : kKinds) {
    const Scene scene = render_scene({.kind = kind});
    int left = 0, right = 0, top = 0, bottom = 0;
    for (Index y = 0; y < 412; ++y) {
      left += scene.binary.at(0, y) / 255;
      right += scene.binary.at(509, y) / 255;
    }
    for (Index x = 0; x < 510; ++x) {
      top += scene.binary.at(x, 0) / 255;
      bottom += scene.binary.at(x, 411) / 255;
    }
    const auto [fewest, most] = std::minmax({left, right, top, bottom});
    EXPECT_TRUE(kind == SceneKind::parts ? most == 0 : fewest > 20) << fewest << ", " << most;
  }
}

TEST(Scene, invalid_options_are_rejected) {
  EXPECT_THROW((void)render_scene({.scale = 0}), std::invalid_argument);
  EXPECT_THROW((void)render_scene({.noise_sigma_16 = -1}), std::invalid_argument);
}

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
