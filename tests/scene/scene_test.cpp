#include "scene/scene.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/flood_fill.hpp"
#include "support/fnv1a.hpp"

namespace thinbench {
namespace {

using flood_fill::Components;
using flood_fill::holes_of;
using flood_fill::objects_of;

// FNV-1a of the grey pixels of both scenes with default options. Recorded from builds by g++ 12 and
// clang++ 14, with -O0 and -O3, which agreed.
constexpr std::uint64_t kPartsHash = 0x6F01900C1697FEB3u;
constexpr std::uint64_t kFrameTouchingHash = 0x731ED37726D961B4u;

constexpr SceneKind kKinds[] = {SceneKind::parts, SceneKind::border_touching};

std::uint64_t fnv1a(ConstImageView image) {
  Fnv1a hash;
  hash.add_pixels(image);
  return hash.value();
}

ConstImageView binary_of(const Scene& scene) {
  return scene.binary.view();
}
ConstImageView grey_of(const Scene& scene) {
  return scene.grey.view();
}

Scene render_kind(SceneKind kind) {
  return render_scene({.kind = kind});
}

Index foreground_pixels(ConstImageView binary) {
  Index count = 0;
  for (Index y = 0; y < binary.height; ++y) {
    count += std::count(binary.row(y), binary.row(y) + binary.width, std::uint8_t{255});
  }
  return count;
}

/// The number of erosions by the 4-neighbourhood until no foreground is left.
int erosions_until_empty(ByteImage image) {
  int count = 0;
  while (foreground_pixels(std::as_const(image).view()) > 0) {
    const ByteImage before = copy_of(std::as_const(image).view());
    for (Index y = 1; y + 1 < image.height(); ++y) {
      for (Index x = 1; x + 1 < image.width(); ++x) {
        image.at(x, y) =
            static_cast<std::uint8_t>(before.at(x, y) & before.at(x - 1, y) & before.at(x + 1, y) &
                                      before.at(x, y - 1) & before.at(x, y + 1));
      }
    }
    ++count;
  }
  return count;
}

/// Whether two objects are closer than `gap` pixels in Chebyshev distance.
bool parts_closer_than(ConstImageView binary, const Components& parts, Index gap) {
  const auto label = [&](Index x, Index y) {
    return parts.label[static_cast<std::size_t>(y * binary.width + x)];
  };
  for (Index y = gap; y < binary.height - gap; ++y) {
    for (Index x = gap; x < binary.width - gap; ++x) {
      if (label(x, y) == 0) continue;
      for (Index dy = -gap; dy <= gap; ++dy) {
        for (Index dx = -gap; dx <= gap; ++dx) {
          const int other = label(x + dx, y + dy);
          if (other != 0 && other != label(x, y)) return true;
        }
      }
    }
  }
  return false;
}

TEST(Scene, grey_bytes_are_the_same_on_every_machine) {
  EXPECT_EQ(fnv1a(grey_of(render_kind(SceneKind::parts))), kPartsHash);
  EXPECT_EQ(fnv1a(grey_of(render_kind(SceneKind::border_touching))), kFrameTouchingHash);
}

TEST(Scene, another_seed_changes_the_noise) {
  EXPECT_FALSE(equal(grey_of(render_scene()), grey_of(render_scene({.seed = 2000}))));
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

TEST(Scene, foreground_share_is_between_35_and_45_percent) {
  const double share =
      static_cast<double>(foreground_pixels(binary_of(render_scene()))) / (510.0 * 412);
  EXPECT_GT(share, 0.35);
  EXPECT_LT(share, 0.45);
}

TEST(Scene, every_part_is_one_8_connected_object_and_every_hole_one_4_connected_hole) {
  for (const SceneKind kind : kKinds) {
    const Scene scene = render_kind(kind);
    EXPECT_GE(scene.parts.size(), 10U);
    EXPECT_GE(scene.holes.size(), 15U);
    EXPECT_EQ(objects_of(binary_of(scene)).list.size(), scene.parts.size());
    EXPECT_EQ(holes_of(binary_of(scene)).size(), scene.holes.size());
  }
}

TEST(Scene, strong_noise_adds_no_object_and_no_hole) {
  for (const SceneKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Scene scene = render_scene({.kind = kind, .noise_sigma_16 = 160, .seed = seed});
      EXPECT_EQ(objects_of(binary_of(scene)).list.size(), scene.parts.size());
      EXPECT_EQ(holes_of(binary_of(scene)).size(), scene.holes.size());
    }
  }
}

TEST(Scene, levels_of_flat_pixels_differ_from_the_threshold_by_at_least_six_sigma) {
  const Scene scene = render_scene({.noise_sigma_16 = 0});
  for (Index y = 2; y < 410; ++y) {
    for (Index x = 2; x < 508; ++x) {
      // Antialiased pixels have neighbours of both kinds.
      bool flat = true;
      for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        flat = flat && scene.binary.at(x + dx, y + dy) == scene.binary.at(x, y) &&
               std::abs(scene.grey.at(x + dx, y + dy) - scene.grey.at(x, y)) < 4;
      }
      if (flat) {
        ASSERT_GE(std::abs(scene.grey.at(x, y) - scene.threshold), 36);
      }
    }
  }
}

TEST(Scene, parts_are_at_least_three_pixels_from_the_image_border) {
  const Scene scene = render_scene();
  for (const ScenePart& part : scene.parts) {
    EXPECT_FALSE(part.cut_by_border);
    EXPECT_GE(part.box.x_min, 2.5);
    EXPECT_GE(part.box.y_min, 2.5);
    EXPECT_LE(part.box.x_max, 510 - 3.5);
    EXPECT_LE(part.box.y_max, 412 - 3.5);
  }
}

TEST(Scene, parts_are_at_least_three_pixels_apart) {
  for (const SceneKind kind : kKinds) {
    const Scene scene = render_kind(kind);
    EXPECT_FALSE(parts_closer_than(binary_of(scene), objects_of(binary_of(scene)), 3));
  }
}

TEST(Scene, thickest_stroke_is_60_pixels_wide) {
  const int erosions = erosions_until_empty(render_scene({.noise_sigma_16 = 0}).binary);
  EXPECT_GE(erosions, 29);
  EXPECT_LE(erosions, 31);
}

TEST(Scene, border_touching_scene_touches_all_sides_and_a_corner) {
  const Scene scene = render_kind(SceneKind::border_touching);
  int left = 0;
  int right = 0;
  int top = 0;
  int bottom = 0;
  for (Index y = 0; y < 412; ++y) {
    left += scene.binary.at(0, y) / 255;
    right += scene.binary.at(509, y) / 255;
  }
  for (Index x = 0; x < 510; ++x) {
    top += scene.binary.at(x, 0) / 255;
    bottom += scene.binary.at(x, 411) / 255;
  }
  EXPECT_GT(std::min({left, right, top, bottom}), 20);
  EXPECT_EQ(scene.binary.at(0, 0), 255);
}

TEST(Scene, invalid_options_are_rejected) {
  EXPECT_THROW((void)render_scene({.scale = 0}), std::invalid_argument);
  EXPECT_THROW((void)render_scene({.noise_sigma_16 = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace thinbench
