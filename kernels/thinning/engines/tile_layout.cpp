// Rows of packed pixels into tiles and back. Compiled once for every instruction-set level.
//
// Rows keep the pixels of neighbouring tiles together, tiles those of neighbouring rows. At AVX-512
// 16 tiles are transposed in registers, 16 loads, 64 shuffles and 16 stores for 8,192 pixels. Other
// ISAs, and what is left at the edges, move a word of two tiles at a time.
#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/tile_passes.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kWordsOf64 = 2;  // strips that one 64-bit word of a plane holds

/// The tile of a row in the first strip of the image.
Index first_tile(const TileGridView& grid, Index tile_row) {
  return grid.strip_tiles + tile_row;
}

/// Tiles of two neighbouring strips, the second of which may be the empty one behind the last.
void load_two_tiles(const TileGridView& grid, const ConstBitPlaneView& rows, Index strip,
                    Index tile_row) {
  const Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  std::uint32_t* low = grid.words + tile * kTileRows;
  std::uint32_t* high = low + grid.strip_tiles * kTileRows;
  std::uint64_t any = 0;
  for (Index y = 0; y < rows.height; ++y) {
    const std::uint64_t word = rows.row(y)[strip / kWordsOf64];
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
    rows.row(y)[strip / kWordsOf64] = low[y] | std::uint64_t{high[y]} << kTileColumns;
  }
}

constexpr Index kTransposedStrips = Square::kSize;
static_assert(!kHasTranspose || Square::kSize == kTileRows);

/// Whole tiles of kTransposedStrips strips. A template, as the next one, for it to be compiled only
/// where squares can be transposed.
template <class View>
void load_transposed(const TileGridView& grid, const View& rows, Index strip, Index tile_row) {
  Square square;
  for (int y = 0; y < kTileRows; ++y) {
    const std::uint64_t* row = rows.row(y) + strip / kWordsOf64;
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
    reinterpreted<WordBatch>(pixels.rows[y]).store_unaligned(rows.row(y) + strip / kWordsOf64);
  }
}

/// Strips that are transposed together; the others follow.
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
  for (; strip * kTileColumns < rows.width; strip += kWordsOf64) {
    load_two_tiles(grid, rows, strip, tile_row);
  }
}

void store_rows(const TileGridView& grid, const BitPlaneView& rows, Index tile_row) {
  Index strip = 0;
  if constexpr (kHasTranspose) {
    const Index end = transposed_strips(rows);
    for (; strip < end; strip += kTransposedStrips) store_transposed(grid, rows, strip, tile_row);
  }
  for (; strip * kTileColumns < rows.width; strip += kWordsOf64) {
    store_two_tiles(grid, rows, strip, tile_row);
  }
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const TileLayout Exported<TileLayout, kThisIsa>::kKernels = {&load_rows, &store_rows};

}  // namespace thinbench::detail
