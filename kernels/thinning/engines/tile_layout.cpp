// Rows of packed pixels into tiles and back. Compiled once for every instruction-set level.
//
// Rows keep the pixels of neighbouring tiles together, tiles those of neighbouring rows. At AVX-512
// 16 tiles are turned in registers, 16 loads, 64 shuffles and 16 stores for 8,192 pixels. Other
// levels, and what is left at the edges, move a word of two tiles at a time.
#include "dispatch/exported.hpp"
#include "simd/batch.hpp"
#include "thinning/engines/tile_passes.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kWordsOf64 = 2;  // strips that one 64-bit word of a plane holds

/// The tile of a row in the first strip of the image.
Index first_tile(const TileGridView& grid, Index tile_row) {
  return grid.strip_tiles + tile_row;
}

/// Tiles of two neighbouring strips, the second of which may be the light one behind the last.
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

#ifdef __AVX512F__

constexpr Index kTurnedStrips = 16;

struct Square {
  __m512i rows[16];  // of 16 lanes
};

/// Lane i of row j becomes lane j of row i.
[[gnu::always_inline]] inline Square turned(const Square& in) {
  Square pairs;
  for (int i = 0; i < 16; i += 2) {
    pairs.rows[i] = _mm512_unpacklo_epi32(in.rows[i], in.rows[i + 1]);
    pairs.rows[i + 1] = _mm512_unpackhi_epi32(in.rows[i], in.rows[i + 1]);
  }
  Square fours;  // rows[4 i + j]: lanes j, j + 4, j + 8, j + 12 of the rows 4 i to 4 i + 3
  for (int i = 0; i < 16; i += 4) {
    fours.rows[i] = _mm512_unpacklo_epi64(pairs.rows[i], pairs.rows[i + 2]);
    fours.rows[i + 1] = _mm512_unpackhi_epi64(pairs.rows[i], pairs.rows[i + 2]);
    fours.rows[i + 2] = _mm512_unpacklo_epi64(pairs.rows[i + 1], pairs.rows[i + 3]);
    fours.rows[i + 3] = _mm512_unpackhi_epi64(pairs.rows[i + 1], pairs.rows[i + 3]);
  }
  constexpr int even = 0x88;  // parts of 128 bits: 0 and 2 of either operand
  constexpr int odd = 0xDD;
  Square out;
  for (int j = 0; j < 4; ++j) {
    const __m512i a = fours.rows[j];
    const __m512i b = fours.rows[j + 4];
    const __m512i c = fours.rows[j + 8];
    const __m512i d = fours.rows[j + 12];
    const __m512i even_ab = _mm512_shuffle_i32x4(a, b, even);
    const __m512i even_cd = _mm512_shuffle_i32x4(c, d, even);
    const __m512i odd_ab = _mm512_shuffle_i32x4(a, b, odd);
    const __m512i odd_cd = _mm512_shuffle_i32x4(c, d, odd);
    out.rows[j] = _mm512_shuffle_i32x4(even_ab, even_cd, even);
    out.rows[j + 4] = _mm512_shuffle_i32x4(odd_ab, odd_cd, even);
    out.rows[j + 8] = _mm512_shuffle_i32x4(even_ab, even_cd, odd);
    out.rows[j + 12] = _mm512_shuffle_i32x4(odd_ab, odd_cd, odd);
  }
  return out;
}

/// Whole tiles of kTurnedStrips strips.
void load_turned(const TileGridView& grid, const ConstBitPlaneView& rows, Index strip,
                 Index tile_row) {
  Square square;
  for (int y = 0; y < kTileRows; ++y) {
    square.rows[y] = _mm512_loadu_si512(rows.row(y) + strip / kWordsOf64);
  }
  const Square tiles = turned(square);
  Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  for (const __m512i& pixels : tiles.rows) {
    _mm512_store_si512(grid.words + tile * kTileRows, pixels);
    grid.changed_rows[tile] = _mm512_test_epi32_mask(pixels, pixels);
    tile += grid.strip_tiles;
  }
}

void store_turned(const TileGridView& grid, const BitPlaneView& rows, Index strip, Index tile_row) {
  Square square;
  Index tile = first_tile(grid, tile_row) + strip * grid.strip_tiles;
  for (__m512i& pixels : square.rows) {
    pixels = _mm512_load_si512(grid.words + tile * kTileRows);
    tile += grid.strip_tiles;
  }
  const Square pixels = turned(square);
  for (int y = 0; y < kTileRows; ++y) {
    _mm512_storeu_si512(rows.row(y) + strip / kWordsOf64, pixels.rows[y]);
  }
}

/// Strips that are turned together; the others follow.
template <class View>
Index turned_strips(const View& rows) {
  if (rows.height < kTileRows) return 0;
  const Index strips = (rows.width + kTileColumns - 1) / kTileColumns;
  return strips / kTurnedStrips * kTurnedStrips;
}

#endif

void load_rows(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row) {
  Index strip = 0;
#ifdef __AVX512F__
  const Index end = turned_strips(rows);
  for (; strip < end; strip += kTurnedStrips) load_turned(grid, rows, strip, tile_row);
#endif
  for (; strip * kTileColumns < rows.width; strip += kWordsOf64) {
    load_two_tiles(grid, rows, strip, tile_row);
  }
}

void store_rows(const TileGridView& grid, const BitPlaneView& rows, Index tile_row) {
  Index strip = 0;
#ifdef __AVX512F__
  const Index end = turned_strips(rows);
  for (; strip < end; strip += kTurnedStrips) store_turned(grid, rows, strip, tile_row);
#endif
  for (; strip * kTileColumns < rows.width; strip += kWordsOf64) {
    store_two_tiles(grid, rows, strip, tile_row);
  }
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const TileLayout Exported<TileLayout, kThisIsa>::kKernels = {&load_rows, &store_rows};

}  // namespace thinbench::detail
