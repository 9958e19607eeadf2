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

struct LoadedGrid {
  LoadedGrid(Index width, Index height, Isa isa = Isa::baseline, Border border = Border::background)
      : layout(kernels_of<TileLayout>(isa)),
        grid(width, height, border, layout.shape),
        view(grid.view()) {}

  void load(const BitPlane& plane) const {
    for (Index row = 0; row < view.tile_rows; ++row) {
      layout.load_rows(view, rows_of(plane.view(), row), row);
    }
  }
  void store(BitPlane& plane) const {
    for (Index row = 0; row < view.tile_rows; ++row) {
      layout.store_rows(view, rows_of(plane.view(), row), row);
    }
  }
  template <class View>
  [[nodiscard]] View rows_of(const View& pixels, Index row) const {
    const Index rows = layout.shape.rows;
    return rows_of_view(pixels, row * rows, std::min((row + 1) * rows, pixels.height));
  }
  [[nodiscard]] std::uint32_t pixels(Index tile, Index y) const {
    return view.words[tile * view.shape.rows + view.shape.word_of_row(y)];
  }
  [[nodiscard]] std::uint32_t pixels_at(Index column, Index y) const {
    return pixels(view.first_tile(y / view.shape.rows) + column, y % view.shape.rows);
  }

  const TileLayout& layout;
  TileGrid grid;
  const TileGridView& view;
};

/// Column and row of the tiles with a bit in a set.
std::vector<std::pair<Index, Index>> tiles_of(const TileGridView& grid, const std::uint64_t* set) {
  std::vector<std::pair<Index, Index>> tiles;
  for (Index word = 0; word < grid.tile_rows * grid.row_words; ++word) {
    for (Index bit = 0; bit < kWordBits; ++bit) {
      if ((set[word] >> bit & 1) == 0) continue;
      const Index tile = grid.first_tiles[word] + bit;
      tiles.emplace_back(tile % grid.stride - 1, tile / grid.stride);
    }
  }
  return tiles;
}

void expect_occupied_where_pixels_are(const LoadedGrid& grid) {
  std::vector<std::pair<Index, Index>> expected;
  for (Index row = 0; row < grid.view.tile_rows; ++row) {
    for (Index column = 0; column * kTileColumns < grid.view.width; ++column) {
      std::uint32_t any = 0;
      for (Index y = 0; y < grid.view.shape.rows; ++y) {
        any |= grid.pixels(grid.view.first_tile(row) + column, y);
      }
      if (any != 0) expected.emplace_back(column, row);
    }
  }
  EXPECT_EQ(tiles_of(grid.view, grid.view.occupied), expected);
}

TEST(TileGrid, every_isa_loads_and_stores_the_same_pixels) {
  const Index width = 2100;  // whole squares of 16 tiles and some more, two words of bits
  const Index height = 90;
  BitPlane plane = noise(width, height);
  for (Index y = 0; y < 40; ++y)
    std::fill_n(plane.view().row(y) + 3, 7, 0);  // some tiles without foreground
  const LoadedGrid expected(width, height);
  expected.load(plane);
  for (const Isa isa : all_isas()) {
    if (!isa_available(isa)) continue;
    const LoadedGrid loaded(width, height, isa);
    loaded.load(plane);
    for (Index y = 0; y < height; ++y) {
      for (Index column = -1; column <= width / kTileColumns + 1; ++column) {
        ASSERT_EQ(loaded.pixels_at(column, y), expected.pixels_at(column, y)) << isa_name(isa);
      }
    }
    expect_occupied_where_pixels_are(loaded);
    BitPlane result(width, height);
    loaded.store(result);
    EXPECT_TRUE(equal_planes(plane.view(), std::as_const(result).view())) << isa_name(isa);
    EXPECT_TRUE(margin_is_zero(result.view())) << isa_name(isa);
  }
}

TEST(TileGrid, edges_are_the_outermost_two_rows_of_tiles) {
  for (const Index height : {64, 62, 33, 17}) {
    const LoadedGrid loaded(100, height);
    loaded.load(noise(100, height));
    const TileGridView& view = loaded.view;
    for (const TileEdges& edges : view.edges) {
      for (Index row = 0; row < view.tile_rows; ++row) {
        for (Index tile = view.first_tile(row) - 1; tile <= view.first_tile(row) + 4; ++tile) {
          EXPECT_EQ(edges.top[0][tile], loaded.pixels(tile, 0));
          EXPECT_EQ(edges.top[1][tile], loaded.pixels(tile, 1));
          EXPECT_EQ(edges.bottom[0][tile], loaded.pixels(tile, view.shape.rows - 1));
          EXPECT_EQ(edges.bottom[1][tile], loaded.pixels(tile, view.shape.rows - 2));
        }
      }
    }
  }
}

TEST(TileGrid, round_trip_keeps_the_pixels_of_images_of_every_size) {
  for (const Index width : {1, 31, 32, 33, 64, 65, 127, 510, 513}) {
    for (const Index height : {1, 31, 32, 33, 64, 100}) {
      const BitPlane plane = noise(width, height);
      BitPlane result(width, height);
      LoadedGrid loaded(width, height);
      loaded.load(plane);
      loaded.store(result);
      EXPECT_TRUE(equal_planes(plane.view(), std::as_const(result).view()))
          << width << " x " << height;
      EXPECT_TRUE(margin_is_zero(result.view())) << width << " x " << height;
      EXPECT_TRUE(margin_is_zero(loaded.view)) << width << " x " << height;
    }
  }
}

TEST(TileGrid, tiles_with_foreground_are_occupied_and_active) {
  const Index rows = kernels_of<TileLayout>(Isa::baseline).shape.rows;
  BitPlane plane(70 * kTileColumns, 2 * rows);
  plane.view().row(rows - 1)[0] = 1;                            // column 0, row 0
  plane.view().row(2 * rows - 1)[31] = std::uint64_t{1} << 31;  // column 62, row 1
  plane.view().row(2 * rows - 1)[32] = 1;                       // column 64, row 1
  const LoadedGrid loaded(70 * kTileColumns, 2 * rows);
  loaded.load(noise(70 * kTileColumns, 2 * rows));
  loaded.load(plane);
  const std::vector<std::pair<Index, Index>> expected = {{0, 0}, {62, 1}, {64, 1}};
  EXPECT_EQ(tiles_of(loaded.view, loaded.view.occupied), expected);
  for (const std::uint64_t* near : loaded.view.near) {
    EXPECT_EQ(tiles_of(loaded.view, near), expected);
  }
  EXPECT_EQ(tiles_of(loaded.view, loaded.view.changes[1].here), expected);
}

TEST(TileGrid, margin_check_detects_a_pixel_outside_the_image) {
  for (const Index word : {0, 1, 2}) {
    const LoadedGrid loaded(40, 20);
    EXPECT_TRUE(margin_is_zero(loaded.view));
    const TileShape& shape = loaded.view.shape;
    // Before the first tile, below the last row, after the last column.
    const Index beyond[] = {0, (loaded.view.first_tile(1)) * shape.rows + shape.word_of_row(4),
                            3 * shape.rows};
    loaded.view.words[beyond[word]] = 1;
    EXPECT_FALSE(margin_is_zero(loaded.view)) << word;
  }
}

TEST(TileGrid, of_more_than_2_to_30_tiles_does_not_fit) {
  const TileShape& shape = kernels_of<TileLayout>(Isa::baseline).shape;
  EXPECT_TRUE(TileGrid::fits(Index{1} << 20, Index{1} << 18, shape));
  EXPECT_FALSE(TileGrid::fits(Index{50'000'000'000}, 1, shape));
}

TEST(TileGrid, marks_the_tiles_on_the_image_border_if_it_is_kept) {
  const Index rows = kernels_of<TileLayout>(Isa::baseline).shape.rows;
  const LoadedGrid plain(4 * kTileColumns, 3 * rows);
  EXPECT_EQ(plain.view.border, nullptr);
  const LoadedGrid kept(3 * kTileColumns + 1, 3 * rows, Isa::baseline, Border::keep);
  EXPECT_EQ(tiles_of(kept.view, kept.view.border),
            (std::vector<std::pair<Index, Index>>{
                {0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {3, 1}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}));
  const LoadedGrid single(1, 1, Isa::baseline, Border::keep);
  EXPECT_EQ(tiles_of(single.view, single.view.border),
            (std::vector<std::pair<Index, Index>>{{0, 0}}));
}

}  // namespace
}  // namespace thinbench::detail
