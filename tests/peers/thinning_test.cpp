// Thinning by other libraries: OpenCV must equal our references, Leptonica must keep topology.
#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "harness/verify.hpp"
#include "holes.hpp"
#include "peers/peers.hpp"
#include "scene/scene.hpp"
#include "support/made_image.hpp"
#include "support/property_images.hpp"

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
  for (const SceneKind kind : {SceneKind::parts, SceneKind::border_touching}) {
    const Scene scene = render_scene({kind});
    for (const char* operation : {"thin_zhang_suen:keep", "thin_guo_hall:keep"}) {
      const auto found = difference(operation, "opencv", scene.binary);
      EXPECT_FALSE(found) << operation << ": " << found.value_or("");
    }
  }
}

/// Adds a margin of one background pixel, which connects all background outside of objects.
ByteImage padded(const ByteImage& image) {
  return image_by(image.width() + 2, image.height() + 2, [&](Index x, Index y) {
    const bool inside = x > 0 && y > 0 && x <= image.width() && y <= image.height();
    return inside ? image.at(x - 1, y - 1) : 0;
  });
}

std::size_t components_of(const ByteImage& image, int connectivity) {
  std::vector<std::int32_t> labels(static_cast<std::size_t>(image.width() * image.height()));
  const auto label = connectivity == 8 ? reference::label_objects : reference::label_objects_4;
  return label(image.view(), {labels.data(), image.width(), image.height()}).size();
}

/// Objects by one connectivity, holes by the other one.
RegionCounts counts_of(const ByteImage& image, int connectivity) {
  const ByteImage all = padded(image);
  const ByteImage background = mapped(all, [](int pixel) { return pixel == 0 ? 255 : 0; });
  return {components_of(all, connectivity), components_of(background, 12 - connectivity) - 1};
}

std::vector<ByteImage> leptonica_images() {
  std::vector<ByteImage> images;
  images.push_back(std::move(render_scene().binary));
  images.push_back(std::move(render_scene({SceneKind::border_touching}).binary));
  std::uint64_t seed = 700;
  for (const int percent : {50, 70, 90}) {
    for (const Index granularity : {1, 2, 4}) {
      images.push_back(noise_image(131, 77, percent, granularity, ++seed));
    }
  }
  return images;
}

class Leptonica : public testing::TestWithParam<int> {
 protected:
  [[nodiscard]] static std::string technique() { return "leptonica_" + std::to_string(GetParam()); }
  [[nodiscard]] static ByteImage thinned(const ByteImage& image) {
    const auto job = peer("thin_guo_hall", technique()).make_job(image.width(), image.height(), 1);
    return std::move(outcome_of(*job, image.view()).image);
  }
};

TEST_P(Leptonica, is_deterministic_and_gives_a_subset) {
  for (const ByteImage& image : leptonica_images()) {
    EXPECT_FALSE(difference("thin_guo_hall", technique(), image));
    EXPECT_EQ(pixels_outside(thinned(image), image), 0);
  }
}

TEST_P(Leptonica, keeps_objects_by_its_connectivity_and_holes_by_the_other) {
  for (const ByteImage& image : leptonica_images()) {
    EXPECT_EQ(counts_of(thinned(image), GetParam()), counts_of(image, GetParam()));
  }
}

INSTANTIATE_TEST_SUITE_P(Connectivity, Leptonica, testing::Values(4, 8));

}  // namespace
}  // namespace thinbench
