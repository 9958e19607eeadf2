#include "engines/tile_grid.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/exported.hpp"
#include "core/planes.hpp"
#include "engines/plane_state.hpp"
#include "engines/tile_passes.hpp"
#include "harness/splitmix64.hpp"
#include "support/margins.hpp"

namespace thinbench::detail {
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

/// A grid with the lists that it fills.
struct LoadedGrid {
  LoadedGrid(Index width, Index height, Isa isa = Isa::baseline, Border border = Border::background)
      : layout(kernels_of<TileLayout>(isa)),
        grid(width, height, border),
        list(static_cast<std::size_t>(grid.view().groups * kTileGroup)),
        visited(static_cast<std::size_t>(grid.group_words())) {}

  /// How many tiles have foreground.
  Index load(const BitPlane& plane) {
    for (Index row = 0; row < grid.tile_rows(); ++row) {
      layout.load_rows(grid.view(), rows_of(plane.view(), row), row);
    }
    return grid.restart(list.data(), visited.data());
  }
  void store(BitPlane& plane) const {
    for (Index row = 0; row < grid.tile_rows(); ++row) {
      layout.store_rows(grid.view(), rows_of(plane.view(), row), row);
    }
  }
  template <class View>
  static View rows_of(const View& view, Index row) {
    return rows_of_view(view, row * kTileRows, std::min((row + 1) * kTileRows, view.height));
  }

  const TileLayout& layout;
  TileGrid grid;
  std::vector<std::uint32_t> list;
  std::vector<std::uint64_t> visited;
};

TEST(TileGrid, every_isa_has_the_same_layout) {
  const Index width = 1100;  // two groups of 16 strips and some more
  const Index height = 40;
  BitPlane plane = noise(width, height);
  for (Index y = 0; y < 20; ++y)
    std::fill_n(plane.view().row(y) + 3, 7, 0);  // some tiles without foreground
  LoadedGrid expected(width, height);
  const Index tiles = expected.load(plane);
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    LoadedGrid loaded(width, height, isa);
    ASSERT_EQ(loaded.load(plane), tiles);
    EXPECT_TRUE(
        std::equal(loaded.list.begin(), loaded.list.begin() + tiles, expected.list.begin()));
    const Index words = expected.grid.view().groups * kTileGroup * kTileRows;
    EXPECT_TRUE(std::equal(loaded.grid.view().words, loaded.grid.view().words + words,
                           expected.grid.view().words))
        << isa_name(isa);
    BitPlane result(width, height);
    loaded.store(result);
    EXPECT_TRUE(equal_planes(plane.view(), std::as_const(result).view())) << isa_name(isa);
    EXPECT_TRUE(margin_is_zero(result.view())) << isa_name(isa);
  }
}

TEST(TileGrid, round_trip_keeps_the_pixels_of_images_of_every_size) {
  for (const Index width : {1, 31, 32, 33, 64, 65, 127, 510, 513}) {
    for (const Index height : {1, 15, 16, 17, 33, 100}) {
      const BitPlane plane = noise(width, height);
      BitPlane result(width, height);
      LoadedGrid loaded(width, height);
      loaded.load(plane);
      loaded.store(result);
      EXPECT_TRUE(equal_planes(plane.view(), std::as_const(result).view()))
          << width << " x " << height;
      EXPECT_TRUE(margin_is_zero(result.view())) << width << " x " << height;
      EXPECT_TRUE(margin_is_zero(loaded.grid.view())) << width << " x " << height;
    }
  }
}

TEST(TileGrid, margin_check_detects_a_pixel_outside_the_image) {
  for (const Index word : {Index{-1}, Index{0}, Index{20}}) {
    LoadedGrid loaded(40, 20);
    EXPECT_TRUE(margin_is_zero(loaded.grid.view()));
    const TileGridView& view = loaded.grid.view();
    view.words[view.strip_tiles * kTileRows + (word == 0 ? -kTileRows : word)] = 1;
    EXPECT_FALSE(margin_is_zero(loaded.grid.view())) << word;
  }
}

}  // namespace
}  // namespace thinbench::detail
