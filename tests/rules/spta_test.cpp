// The documented properties of the original SPTA, on its reference.
#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "support/flood_fill.hpp"
#include "support/property_images.hpp"
#include "support/reference_thinning.hpp"

namespace thinbench {
namespace {

ByteImage thinned(const ByteImage& image) {
  return thinned_by_reference(Rule::spta, image).image;
}

void expect_properties(const ByteImage& image, const std::string& name) {
  const ByteImage skeleton = thinned(image);
  ASSERT_EQ(flood_fill::objects_of(skeleton.view()).list.size(),
            flood_fill::objects_of(image.view()).list.size())
      << name;
  ASSERT_EQ(flood_fill::holes_of(skeleton.view()).size(), flood_fill::holes_of(image.view()).size())
      << name;
  ASSERT_EQ(pixels_outside(skeleton, image), 0) << name;
  ASSERT_TRUE(equal(thinned(skeleton).view(), skeleton.view())) << name << " is not idempotent";
}

TEST(Spta, keeps_topology_and_is_idempotent_on_all_four_by_four) {
  for (std::uint64_t bits = 0; bits < 65536; ++bits) {
    expect_properties(image_of_bits(4, 4, bits), std::to_string(bits));
  }
}

TEST(Spta, keeps_topology_and_is_idempotent_on_noise) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto granularity = static_cast<Index>(1 + seed % 7);
    expect_properties(noise_image(90, 70, static_cast<int>(30 + seed), granularity, seed),
                      "seed " + std::to_string(seed));
  }
}

}  // namespace
}  // namespace thinbench
