#include "out_of_core/tiling.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "support/rejection.hpp"
#include "thinbench/options.hpp"

namespace thinbench {
namespace {

TEST(Tiling, tiles_partition_the_image_and_their_halos_lie_in_it) {
  const Tiling tiling = {203, 100, 64, 40, 10, 5};
  std::vector<int> covered(203 * 100);
  for (Index tile = 0; tile < tiling.count(); ++tile) {
    const Block inner = tiling.block(tile);
    const Block outer = tiling.block_with_halo(tile);
    EXPECT_EQ(inner.x % 8, 0);
    EXPECT_EQ(outer.x % 8, 0);
    EXPECT_TRUE(outer.x == 0 || outer.x <= inner.x - 10);
    EXPECT_TRUE(outer.y == 0 || outer.y == inner.y - 10);
    EXPECT_LE(outer.x + outer.width, 203);
    EXPECT_LE(outer.y + outer.height, 100);
    EXPECT_LE(outer.row_bytes() * outer.height, tiling.max_block_bytes());
    for (Index y = inner.y; y < inner.y + inner.height; ++y) {
      for (Index x = inner.x; x < inner.x + inner.width; ++x) {
        ++covered[static_cast<std::size_t>(y * 203 + x)];
      }
    }
  }
  EXPECT_EQ(covered, std::vector<int>(203 * 100, 1));
}

TEST(TilingFor, keeps_blocks_below_the_limit_and_halos_deep_enough) {
  for (const Index width : {Index{70}, Index{5000}, Index{100'000}, Index{1} << 30}) {
    for (const Index height : {Index{70}, Index{5000}, Index{100'000}}) {
      for (const Index bytes : {Index{1} << 16, Index{1} << 20, Index{1} << 26}) {
        const Tiling tiling = tiling_for(width, height, 4, bytes);
        EXPECT_LE(tiling.max_block_bytes(), bytes) << width << " x " << height;
        if (tiling.count() == 1) continue;
        EXPECT_GE(tiling.halo, 4 * tiling.iterations);
        EXPECT_GE(tiling.iterations, 2);
        EXPECT_TRUE(tiling.columns() == 1 || tiling.tile_width >= tiling.halo);
        EXPECT_TRUE(tiling.rows() == 1 || tiling.tile_height >= tiling.halo);
      }
    }
  }
}

TEST(TilingFor, image_that_fits_is_one_tile_without_a_halo) {
  const Tiling tiling = tiling_for(1001, 1000, 2, 1 << 20);
  EXPECT_EQ(tiling.count(), 1);
  EXPECT_EQ(tiling.halo, 0);
  EXPECT_EQ(tiling.iterations, kUnlimited);
}

TEST(TilingFor, too_little_memory_is_rejected) {
  EXPECT_EQ(rejection_of([] { static_cast<void>(tiling_for(5000, 5000, 4, 64)); }),
            "blocks of 64 bytes are too small for tiles and their halo");
}

TEST(WithNeighbours, marks_the_eight_neighbours) {
  const Tiling tiling = {30, 30, 8, 8, 2, 1};  // 4 x 4 tiles
  std::vector<bool> tiles(16);
  tiles[5] = true;
  std::vector<bool> expected(16);
  for (const std::size_t tile : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) expected[tile] = true;
  EXPECT_EQ(with_neighbours(tiling, tiles), expected);
}

}  // namespace
}  // namespace thinbench
