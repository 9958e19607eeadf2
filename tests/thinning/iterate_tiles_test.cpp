#include "thinning/iterate_tiles.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "thinbench.hpp"

namespace thinbench {
namespace {

/// Runs a rule by tiles on the highest level; the number of cycles.
int thin_by_tiles(std::string_view operation, const ByteImage& image, ByteImage& skeleton,
                  int threads = 1) {
  return thin(operation, image.view(), skeleton.view(),
              {.technique = Technique::kSimdBitpackedTiles, .threads = threads});
}

/// Squares on a raster, so that tiles fall quiet at different times.
ByteImage squares(Index width, Index height, Index side) {
  ByteImage image(width, height);
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      const Index size = 2 + (x / side + 3 * (y / side)) % (side - 2);
      image.at(x, y) = x % side < size && y % side < size ? 255 : 0;
    }
  }
  return image;
}

TEST(IterateTiles, equals_the_reference_where_more_tiles_are_active_than_the_ring_holds) {
  for (const Index side : {7, 40, 130}) {
    const ByteImage image = squares(1000, 400, side);
    ByteImage by_tiles(1000, 400);
    ByteImage by_reference(1000, 400);
    const int cycles = thin_by_tiles("thin_guo_hall", image, by_tiles);
    EXPECT_EQ(cycles,
              reference::thin_guo_hall(Border::kBackground, image.view(), by_reference.view()));
    EXPECT_TRUE(equal(by_tiles.view(), by_reference.view())) << "side " << side;
  }
}

TEST(IterateTiles, groups_beyond_the_first_word_are_found) {
  const ByteImage image = squares(4500, 300, 64);  // more than 64 groups of tiles
  ByteImage by_tiles(4500, 300);
  ByteImage by_reference(4500, 300);
  thin_by_tiles("thin_zhang_suen", image, by_tiles);
  reference::thin_zhang_suen(Border::kBackground, image.view(), by_reference.view());
  EXPECT_TRUE(equal(by_tiles.view(), by_reference.view()));
}

TEST(IterateTiles, threads_that_share_a_step_give_the_same) {
  const ByteImage image = squares(2000, 1200, 90);
  ByteImage one(2000, 1200);
  ByteImage many(2000, 1200);
  for (const int threads : {2, 3, 7}) {
    const int cycles = thin_by_tiles("thin_spta_directional", image, one);
    EXPECT_EQ(cycles, thin_by_tiles("thin_spta_directional", image, many, threads));
    EXPECT_TRUE(equal(one.view(), many.view())) << threads << " threads";
  }
}

TEST(IterateTiles, a_light_image_takes_one_cycle) {
  const ByteImage light(70, 70);
  ByteImage result(70, 70);
  EXPECT_EQ(thin_by_tiles("thin_guo_hall", light, result), 1);
  EXPECT_TRUE(equal(light.view(), result.view()));
}

}  // namespace
}  // namespace thinbench
