#include "thinning/tile_grid.hpp"

#include <gtest/gtest.h>

#include "core/planes.hpp"
#include "support/splitmix64.hpp"

namespace thinbench {
namespace {

BitPlane noise(Index width, Index height) {
  BitPlane plane(width, height);
  std::uint64_t index = 0;
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      plane.view().row(y)[x / kWordBits] |= (splitmix64(1, index++) & 1) << (x % kWordBits);
    }
  }
  return plane;
}

bool equal_planes(const ConstBitPlaneView& a, const ConstBitPlaneView& b) {
  for (Index y = 0; y < a.height; ++y) {
    if (!std::equal(a.row(y), a.row(y) + a.row_elements, b.row(y))) return false;
  }
  return true;
}

TEST(TileGrid, gives_back_the_pixels_of_every_size) {
  for (const Index width : {1, 31, 32, 33, 64, 65, 127, 510, 513}) {
    for (const Index height : {1, 15, 16, 17, 33, 100}) {
      const BitPlane plane = noise(width, height);
      BitPlane result(width, height);
      TileGrid grid(width, height);
      grid.load(plane.view(), ThreadTeam(1));
      grid.store(result.view(), ThreadTeam(1));
      EXPECT_TRUE(equal_planes(plane.view(), std::as_const(result).view()))
          << width << " x " << height;
      EXPECT_TRUE(result.margin_is_zero()) << width << " x " << height;
    }
  }
}

TEST(TileGrid, lists_the_tiles_that_have_dark_pixels) {
  BitPlane plane(3 * kTileColumns, 2 * kTileRows);
  plane.view().row(kTileRows - 1)[0] = 1;                           // strip 0, tile 0
  plane.view().row(2 * kTileRows - 1)[1] = std::uint64_t{1} << 31;  // strip 2, tile 1
  TileGrid grid(3 * kTileColumns, 2 * kTileRows);
  ASSERT_EQ(grid.load(std::as_const(plane).view(), ThreadTeam(1)), 2);
  const TileGridView& view = grid.view();
  EXPECT_EQ(view.active[0], view.strip_tiles);
  EXPECT_EQ(view.active[1], 3 * view.strip_tiles + 1);
}

TEST(TileGrid, a_second_image_leaves_nothing_of_the_first) {
  const BitPlane first = noise(100, 50);
  const BitPlane light(100, 50);
  BitPlane result(100, 50);
  TileGrid grid(100, 50);
  grid.load(first.view(), ThreadTeam(1));
  EXPECT_EQ(grid.load(light.view(), ThreadTeam(1)), 0);
  grid.store(result.view(), ThreadTeam(1));
  EXPECT_TRUE(equal_planes(light.view(), std::as_const(result).view()));
}

TEST(TileGrid, neighbours_of_every_tile_lie_inside_and_are_light_beyond_the_image) {
  TileGrid grid(40, 20);
  BitPlane dark(40, 20);
  for (Index y = 0; y < 20; ++y) dark.view().row(y)[0] = (std::uint64_t{1} << 40) - 1;
  grid.load(std::as_const(dark).view(), ThreadTeam(1));
  const TileGridView& view = grid.view();
  const std::uint32_t* first = view.words + view.strip_tiles * kTileRows;
  EXPECT_EQ(first[0], 0xFFFFFFFFU);
  EXPECT_EQ(first[-1], 0U);
  EXPECT_EQ(first[19], 0xFFFFFFFFU);
  EXPECT_EQ(first[20], 0U);
  EXPECT_EQ(first[-view.strip_tiles * kTileRows], 0U);
  EXPECT_EQ(first[view.strip_tiles * kTileRows], 0xFFU);
  EXPECT_EQ(first[2 * view.strip_tiles * kTileRows], 0U);
}

}  // namespace
}  // namespace thinbench
