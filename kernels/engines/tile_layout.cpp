// Converts rows of packed pixels to tiles and back. Compiled once for every ISA.
//
// AVX-512 transposes 16 tiles in registers: 16 loads, 64 shuffles and 16 stores for 8,192 pixels.
// Other ISAs, and the remainder at the edges, move one 64-bit word of two tiles at a time.
#include "core/exported.hpp"
#include "engines/tile_passes.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kStripsPerWord = 2;  // of 64 bits

/// The tile of a row of tiles in the first strip of the image.
Index first_tile(const TileGridView& grid, Index tile_row) {
  return grid.strip_tiles + tile_row;
}

/// Loads tiles of two adjacent strips. The second may be the background strip after the last.
void load_two_tiles(const TileGridView& grid, const ConstBitPlaneView& rows, Index strip,
                    Index tile_row) {
  const Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  std::uint32_t* low = grid.words + tile * kTileRows;
  std::uint32_t* high = low + grid.strip_tiles * kTileRows;
  std::uint64_t any = 0;
  for (Index y = 0; y < rows.height; ++y) {
    const std::uint64_t word = rows.row(y)[strip / kStripsPerWord];
    low[y] = static_cast<std::uint32_t>(word);
    high[y] = static_cast<std::uint32_t>(word >> kTileColumns);
    any |= word;
  }
  grid.changed_rows[tile] = static_cast<std::uint32_t>(any) != 0 ? 1 : 0;
  grid.changed_rows[tile + grid.strip_tiles] = any >> kTileColumns != 0 ? 1 : 0;
}

void store_two_tiles(const TileGridView& grid, const BitPlaneView& rows, Index strip,
                     Index tile_row) {
  const Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  const std::uint32_t* low = grid.words + tile * kTileRows;
  const std::uint32_t* high = low + grid.strip_tiles * kTileRows;
  for (Index y = 0; y < rows.height; ++y) {
    rows.row(y)[strip / kStripsPerWord] = low[y] | std::uint64_t{high[y]} << kTileColumns;
  }
}

constexpr Index kTransposedStrips = Square::kSize;
static_assert(!kHasTranspose || Square::kSize == kTileRows);

/// Loads whole tiles of kTransposedStrips strips. This and store_transposed() are templates so that
/// they are instantiated only on ISAs that can transpose a Square.
template <class View>
void load_transposed(const TileGridView& grid, const View& rows, Index strip, Index tile_row) {
  Square square;
  for (int y = 0; y < kTileRows; ++y) {
    const std::uint64_t* row = rows.row(y) + strip / kStripsPerWord;
    square.rows[y] = reinterpreted<Lanes32>(WordBatch::load_unaligned(row));
  }
  const Square tiles = transposed(square);
  Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  for (const Lanes32& pixels : tiles.rows) {
    pixels.store_aligned(grid.words + tile * kTileRows);
    grid.changed_rows[tile] = static_cast<std::uint16_t>(nonzero_lanes(pixels));
    tile += grid.strip_tiles;
  }
}

template <class View>
void store_transposed(const TileGridView& grid, const View& rows, Index strip, Index tile_row) {
  Square square;
  Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  for (Lanes32& pixels : square.rows) {
    pixels = Lanes32::load_aligned(grid.words + tile * kTileRows);
    tile += grid.strip_tiles;
  }
  const Square pixels = transposed(square);
  for (int y = 0; y < kTileRows; ++y) {
    reinterpreted<WordBatch>(pixels.rows[y]).store_unaligned(rows.row(y) + strip / kStripsPerWord);
  }
}

/// The number of leading strips that can be transposed in whole squares.
template <class View>
Index transposed_strips(const View& rows) {
  if (rows.height < kTileRows) return 0;
  const Index strips = (rows.width + kTileColumns - 1) / kTileColumns;
  return strips / kTransposedStrips * kTransposedStrips;
}

void load_rows(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row) {
  Index strip = 0;
  if constexpr (kHasTranspose) {
    const Index end = transposed_strips(rows);
    for (; strip < end; strip += kTransposedStrips) load_transposed(grid, rows, strip, tile_row);
  }
  for (; strip * kTileColumns < rows.width; strip += kStripsPerWord) {
    load_two_tiles(grid, rows, strip, tile_row);
  }
}

void store_rows(const TileGridView& grid, const BitPlaneView& rows, Index tile_row) {
  Index strip = 0;
  if constexpr (kHasTranspose) {
    const Index end = transposed_strips(rows);
    for (; strip < end; strip += kTransposedStrips) store_transposed(grid, rows, strip, tile_row);
  }
  for (; strip * kTileColumns < rows.width; strip += kStripsPerWord) {
    store_two_tiles(grid, rows, strip, tile_row);
  }
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const TileLayout Exported<TileLayout, kThisIsa>::kKernels = {&load_rows, &store_rows};

}  // namespace thinbench::detail
