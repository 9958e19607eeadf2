// The original SPTA: what it promises, on its reference; the variants are compared with that.
#include "thinning/engines/spta.hpp"

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "reference.hpp"
#include "scene/components.hpp"

namespace thinbench {
namespace {

ByteImage thinned(const ByteImage& image) {
  ByteImage skeleton(image.width(), image.height());
  reference::thin_spta(image.view(), skeleton.view());
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
  ASSERT_EQ(scene_test::objects_of(skeleton.view()).list.size(),
            scene_test::objects_of(image.view()).list.size())
      << name;
  ASSERT_EQ(scene_test::holes_of(skeleton.view()).size(), scene_test::holes_of(image.view()).size())
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

/// The expressions as printed, of a pass in which nothing is flagged yet.
bool expression(int side, unsigned k) {
  const auto n = [k](int i) { return (k >> i & 1) != 0; };
  switch (side) {
    case 4:
      return n(0) && (n(1) || n(2) || n(6) || n(7)) && (n(2) || !n(3)) && (!n(5) || n(6));
    case 0:
      return n(4) && (n(2) || n(3) || n(5) || n(6)) && (n(6) || !n(7)) && (!n(1) || n(2));
    case 2:
      return n(6) && (n(0) || n(4) || n(5) || n(7)) && (n(0) || !n(1)) && (!n(3) || n(4));
    default:
      return n(2) && (n(0) || n(1) || n(3) || n(4)) && (n(4) || !n(5)) && (!n(7) || n(0));
  }
}

TEST(Spta, turned_expressions_are_the_printed_ones) {
  for (unsigned k = 0; k < 256; ++k) {
    const auto edge = [k](int side) { return (k >> side & 1) == 0 && expression(side, k); };
    EXPECT_EQ(spta_flags(SptaScan::left_right, k, k), edge(4) || edge(0)) << k;
    EXPECT_EQ(spta_flags(SptaScan::top_bottom, k, k), edge(2) || edge(6)) << k;
  }
}

}  // namespace
}  // namespace thinbench
