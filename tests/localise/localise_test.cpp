// Localisation: which pixels belong to objects, and how close centres are to the true ones.
#include "localise.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/packing.hpp"
#include "harness/test_images.hpp"
#include "localise/state.hpp"
#include "scene/scene.hpp"
#include "support/made_image.hpp"
#include "support/margins.hpp"
#include "thinbench/localise.hpp"

namespace thinbench {
namespace {

using detail::BitPlane;
using detail::localise_operation;
using detail::LocaliseVariant;

ByteImage reference_objects(const ByteImage& contours) {
  ByteImage objects(contours.width(), contours.height());
  reference::outlined_objects(contours.view(), objects.view());
  return objects;
}

ByteImage packed_objects(const ByteImage& contours) {
  const auto& conversion = detail::plane_conversion<std::uint64_t>(Isa::baseline);
  BitPlane from(contours.width(), contours.height());
  BitPlane to(contours.width(), contours.height());
  conversion.read(contours.view(), from.view());
  detail::OutlinedObjects(best_isa(), contours.width(), contours.height())
      .write(from.view(), to.view());
  EXPECT_TRUE(margin_is_zero(to.view()));
  ByteImage objects(contours.width(), contours.height());
  conversion.write(to.view(), objects.view());
  return objects;
}

TEST(OutlinedObjects, extend_from_the_outermost_contour_to_the_next_one) {
  const ByteImage contours =
      image_of({"#########..", "#.......#.#", "#.#####.#..", "#.#...#.#..", "#.#.#.#.#..",
                "#.#...#.#..", "#.#####.###", "#.......#.#", "###########"});
  const ByteImage objects =
      image_of({"#########..", "#########.#", "##.....##..", "##.....##..", "##.....##..",
                "##.....##..", "##.....####", "###########", "###########"});
  EXPECT_EQ(text_of(reference_objects(contours)), text_of(objects));
  EXPECT_EQ(text_of(packed_objects(contours)), text_of(objects));
}

TEST(OutlinedObjects, contour_with_a_gap_encloses_nothing) {
  const ByteImage contours = image_of({"####", "#..#", "#...", "####"});
  EXPECT_EQ(text_of(packed_objects(contours)), text_of(contours));
}

double distance(const Region& region, const ScenePoint& centre) {
  return std::hypot(region.centre_x() - centre.x, region.centre_y() - centre.y);
}

/// The number of the only region with its centre within `tolerance`; 0 if there is none or several.
std::size_t id_at(const std::vector<Region>& found, const ScenePoint& centre, double tolerance) {
  std::size_t id = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (distance(found[i], centre) > tolerance) continue;
    if (id != 0) return 0;
    id = i + 1;
  }
  return id;
}

// At sigma 8 two specks of noise become objects. The true centre of an object is that of its area
// without holes.
constexpr double kHoleTolerance = 0.25;
constexpr double kObjectTolerance = 0.5;

TEST(LocaliseObjects, finds_exactly_the_parts_of_the_scene_and_their_holes) {
  for (const int sigma : {0, 2, 4, 6}) {
    SceneOptions options;
    options.noise_sigma_16 = 16 * sigma;
    const Scene scene = render_scene(options);
    const Regions found = localise_objects(scene.grey.view());
    EXPECT_EQ(found.objects.size(), scene.parts.size()) << sigma;
    EXPECT_EQ(found.holes.size(), scene.holes.size()) << sigma;
    for (const SceneHole& hole : scene.holes) {
      const ScenePart& part = scene.parts[static_cast<std::size_t>(hole.part - 1)];
      const std::size_t object = id_at(found.objects, part.centre, kObjectTolerance);
      const std::size_t id = id_at(found.holes, hole.centre, kHoleTolerance);
      ASSERT_NE(object, 0U) << part.kind << " " << part.id << ", sigma " << sigma;
      ASSERT_NE(id, 0U) << hole.kind << " " << hole.id << ", sigma " << sigma;
      EXPECT_EQ(found.holes[id - 1].enclosing_object, object) << hole.id;
    }
  }
}

TEST(LocaliseObjects, overestimates_the_areas_of_holes) {
  SceneOptions options;
  options.noise_sigma_16 = 0;
  const Scene scene = render_scene(options);
  const Regions found = localise_objects(scene.grey.view());
  for (const SceneHole& hole : scene.holes) {
    const std::size_t id = id_at(found.holes, hole.centre, kHoleTolerance);
    ASSERT_NE(id, 0U);
    EXPECT_GT(static_cast<double>(found.holes[id - 1].area), hole.area) << hole.id;
  }
}

TEST(LocaliseState, every_variant_equals_the_reference_with_every_edge_operator) {
  const Scene scene = render_scene();
  const ConstImageView grey = scene.grey.view();
  for (const EdgeOperatorInfo& edges : kEdgeOperators) {
    const reference::Regions expected =
        reference::localise_objects(reference::edges(edges.op), {40, 128}, grey);
    for (const LocaliseVariant& variant : localise_operation().variants) {
      if (!unavailable_reason(variant, grey.width).empty()) continue;
      const auto state = make_state(variant, grey.width, grey.height, {edges.op, {40, 128}}, 3);
      Regions found;
      state->run(grey, found);
      EXPECT_EQ(found.objects, expected.objects) << edges.name << " at " << isa_name(variant.isa);
      EXPECT_EQ(found.holes, expected.holes) << edges.name << " at " << isa_name(variant.isa);
    }
  }
}

}  // namespace
}  // namespace thinbench
