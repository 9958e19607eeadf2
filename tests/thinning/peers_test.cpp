// Other people's thinning beside ours: compared as far as it can be.
#include "peers/peers.hpp"

#include <gtest/gtest.h>

#include "harness/crosscheck.hpp"
#include "scene/components.hpp"
#include "scene/scene.hpp"

namespace thinbench {
namespace {

const Operation& with_peers(std::string_view name) {
  for (const Operation& operation : operations_with_peers()) {
    if (operation.name == name) return operation;
  }
  throw std::logic_error("no such operation");
}

const Variant& peer(std::string_view operation, std::string_view technique) {
  for (const Variant& variant : with_peers(operation).variants) {
    if (variant.technique == technique) return variant;
  }
  throw std::logic_error("no such peer");
}

std::optional<std::string> difference(std::string_view operation, std::string_view technique,
                                      const ByteImage& image) {
  const Variant& variant = peer(operation, technique);
  const auto job = variant.make_job(image.width(), image.height(), 1);
  return find_mismatch(*job, image.view(),
                       expected_of(with_peers(operation), variant, image.view()));
}

TEST(ThinningPeers, opencv_equals_the_references_that_keep_the_border) {
  for (const SceneKind kind : {SceneKind::kParts, SceneKind::kFrameTouching}) {
    const Scene scene = render_scene({kind});
    for (const char* operation : {"thin_zhang_suen", "thin_guo_hall"}) {
      const auto found = difference(operation, "opencv", scene.binary);
      EXPECT_FALSE(found) << operation << ": " << found.value_or("");
    }
  }
}

TEST(ThinningPeers, opencv_differs_from_the_plain_reference_at_the_frame) {
  const Scene scene = render_scene({SceneKind::kFrameTouching});
  const auto job = peer("thin_guo_hall", "opencv").make_job(510, 412, 1);
  const Outcome plain = expected_of("thin_guo_hall", scene.binary.view());
  EXPECT_FALSE(equal(outcome_of(*job, scene.binary.view()).image.view(), plain.image.view()));
}

TEST(ThinningPeers, leptonica_gives_the_same_again_a_subset_and_as_many_objects) {
  const Scene scene = render_scene();
  for (const char* technique : {"leptonica_4", "leptonica_8"}) {
    EXPECT_FALSE(difference("thin_guo_hall", technique, scene.binary)) << technique;
    const auto job = peer("thin_guo_hall", technique).make_job(510, 412, 1);
    const ByteImage skeleton = std::move(outcome_of(*job, scene.binary.view()).image);
    EXPECT_EQ(scene_test::objects_of(skeleton.view()).list.size(),
              scene_test::objects_of(scene.binary.view()).list.size());
    Index outside = 0;
    for (Index y = 0; y < 412; ++y) {
      for (Index x = 0; x < 510; ++x) {
        outside += skeleton.at(x, y) != 0 && scene.binary.at(x, y) == 0 ? 1 : 0;
      }
    }
    EXPECT_EQ(outside, 0);
  }
}

}  // namespace
}  // namespace thinbench
