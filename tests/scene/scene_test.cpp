#include "scene/scene.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace thinbench
