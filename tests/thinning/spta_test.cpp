// The original SPTA: what it promises, on its reference; the variants are compared with that.
#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "reference.hpp"
#include "support/flood_fill.hpp"

namespace thinbench {
namespace {

ByteImage thinned(const ByteImage& image) {
  ByteImage skeleton(image.width(), image.height());
  reference::thinning(Rule::spta)({}, image.view(), skeleton.view());
  return skeleton;
}

bool is_subset(const ByteImage& part, const ByteImage& whole) {
  for (Index y = 0; y < part.height(); ++y) {
    for (Index x = 0; x < part.width(); ++x) {
      if (part.at(x, y) != 0 && whole.at(x, y) == 0) return false;
    }
  }
  return true;
}

void expect_promises(const ByteImage& image, const std::string& name) {
  const ByteImage skeleton = thinned(image);
  ASSERT_EQ(flood_fill::objects_of(skeleton.view()).list.size(),
            flood_fill::objects_of(image.view()).list.size())
      << name;
  ASSERT_EQ(flood_fill::holes_of(skeleton.view()).size(), flood_fill::holes_of(image.view()).size())
      << name;
  ASSERT_TRUE(is_subset(skeleton, image)) << name;
  ASSERT_TRUE(equal(thinned(skeleton).view(), skeleton.view())) << name << " is not idempotent";
}

TEST(Spta, keeps_topology_and_is_idempotent_on_all_images_of_four_by_four) {
  for (std::uint64_t bits = 0; bits < 65536; ++bits) {
    expect_promises(image_of_bits(4, 4, bits), std::to_string(bits));
  }
}

TEST(Spta, keeps_topology_and_is_idempotent_on_noise) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto granularity = static_cast<Index>(1 + seed % 7);
    expect_promises(noise_image(90, 70, static_cast<int>(30 + seed), granularity, seed),
                    "seed " + std::to_string(seed));
  }
}

}  // namespace
}  // namespace thinbench
