// Converts rows of packed pixels to tiles and back. Compiled per ISA.
//
// AVX-512 transposes 16 tiles in registers, every second row at a time: 16 loads, 64 shuffles and
// 16 stores for 8,192 pixels. Other ISAs, and the remainder at the edges, move one 64-bit word of
// two tiles at a time.
#include <algorithm>

#include "core/exported.hpp"
#include "engines/tile_passes.hpp"
#include "engines/tile_registers.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

constexpr Index kColumnsPerWord = 2;  // of tiles, in 64 bits

/// Marks tiles with foreground, from `column` on.
void mark_occupied(const TileGridView& grid, Index tile_row, Index column, std::uint64_t tiles) {
  const Index bit = column + 1;
  const auto shift = static_cast<int>(bit % kWordBits);
  std::uint64_t* const word = grid.occupied + grid.first_word(tile_row) + bit / kWordBits;
  word[0] |= tiles << shift;
  if (shift != 0 && tiles >> (kWordBits - shift) != 0) word[1] |= tiles >> (kWordBits - shift);
}

/// Loads tiles of two adjacent columns. The second may be the background tile after the last.
void load_two_tiles(const TileGridView& grid, const ConstBitPlaneView& rows, Index column,
                    Index tile_row) {
  std::uint32_t* const low = grid.words + (grid.first_tile(tile_row) + column) * kTileRows;
  std::uint32_t* const high = low + kTileRows;
  std::uint64_t any = 0;
  for (Index y = 0; y < kTileRows; ++y) {
    const std::uint64_t word = y < rows.height ? rows.row(y)[column / kColumnsPerWord] : 0;
    low[kTileShape.word_of_row(y)] = static_cast<std::uint32_t>(word);
    high[kTileShape.word_of_row(y)] = static_cast<std::uint32_t>(word >> kTileColumns);
    any |= word;
  }
  const std::uint64_t in_low = static_cast<std::uint32_t>(any) != 0 ? 1 : 0;
  mark_occupied(grid, tile_row, column, in_low | (any >> kTileColumns != 0 ? 2 : 0));
}

void store_two_tiles(const TileGridView& grid, const BitPlaneView& rows, Index column,
                     Index tile_row) {
  const std::uint32_t* low = grid.words + (grid.first_tile(tile_row) + column) * kTileRows;
  const std::uint32_t* high = low + kTileRows;
  for (Index y = 0; y < rows.height; ++y) {
    const Index word = kTileShape.word_of_row(y);
    rows.row(y)[column / kColumnsPerWord] = low[word] | std::uint64_t{high[word]} << kTileColumns;
  }
}

/// Loads whole tiles of a square's number of columns. This and store_transposed() are templates so
/// that they are instantiated only on ISAs that can transpose a Square.
template <class View>
void load_transposed(const TileGridView& grid, const View& rows, Index column, Index tile_row) {
  std::uint32_t* const tiles = grid.words + (grid.first_tile(tile_row) + column) * kTileRows;
  Lanes32 any(0);
  for (Index number = 0; number < kTileRegisters; ++number) {
    Square square;
    for (Index lane = 0; lane < kTileLanes; ++lane) {
      const std::uint64_t* row =
          rows.row(lane * kTileRegisters + number) + column / kColumnsPerWord;
      square.rows[lane] = reinterpreted<Lanes32>(WordBatch::load_unaligned(row));
      any = any | square.rows[lane];
    }
    const Square registers = transposed(square);
    for (Index tile = 0; tile < kTileLanes; ++tile) {
      registers.rows[tile].store_aligned(tiles + tile * kTileRows + number * kTileLanes);
    }
  }
  mark_occupied(grid, tile_row, column, nonzero_lanes(any));
}

template <class View>
void store_transposed(const TileGridView& grid, const View& rows, Index column, Index tile_row) {
  const std::uint32_t* const tiles = grid.words + (grid.first_tile(tile_row) + column) * kTileRows;
  for (Index number = 0; number < kTileRegisters; ++number) {
    Square square;
    for (Index tile = 0; tile < kTileLanes; ++tile) {
      square.rows[tile] = Lanes32::load_aligned(tiles + tile * kTileRows + number * kTileLanes);
    }
    const Square pixels = transposed(square);
    for (Index lane = 0; lane < kTileLanes; ++lane) {
      std::uint64_t* row = rows.row(lane * kTileRegisters + number) + column / kColumnsPerWord;
      reinterpreted<WordBatch>(pixels.rows[lane]).store_unaligned(row);
    }
  }
}

/// The number of leading columns that can be transposed in whole squares.
template <class View>
Index transposed_columns(const View& rows) {
  if (rows.height < kTileRows) return 0;
  const Index columns = (rows.width + kTileColumns - 1) / kTileColumns;
  return columns / kTileLanes * kTileLanes;
}

/// Copies row `y`, or background beyond the last row, to edges of the tiles.
void load_edge(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row, Index y,
               std::uint32_t* to, std::uint32_t* copy) {
  const Index first = grid.first_tile(tile_row);
  const Index words = (rows.width + kWordBits - 1) / kWordBits;
  const std::uint64_t* const row = y < rows.height ? rows.row(y) : nullptr;
  for (std::uint32_t* edge : {to + first, copy + first}) {
    for (Index i = 0; i < words; ++i) {
      const std::uint64_t word = row != nullptr ? row[i] : 0;
      edge[kColumnsPerWord * i] = static_cast<std::uint32_t>(word);
      edge[kColumnsPerWord * i + 1] = static_cast<std::uint32_t>(word >> kTileColumns);
    }
  }
}

/// The first sub-iteration finds its tiles in the changes of the last, the others in `near`.
void activate_occupied(const TileGridView& grid, Index tile_row) {
  const Index first = grid.first_word(tile_row);
  const std::uint64_t* const from = grid.occupied + first;
  const TileChanges& changes = grid.changes[1];
  std::copy_n(from, grid.row_words, changes.here + first);
  std::fill_n(changes.below + first, grid.row_words, 0);
  std::fill_n(changes.above + first, grid.row_words, 0);
  for (std::uint64_t* near : grid.near) std::copy_n(from, grid.row_words, near + first);
}

void load_rows(const TileGridView& grid, const ConstBitPlaneView& rows, Index tile_row) {
  std::fill_n(grid.occupied + grid.first_word(tile_row), grid.row_words, 0);
  Index column = 0;
  if constexpr (kHasTranspose) {
    const Index end = transposed_columns(rows);
    for (; column < end; column += kTileLanes) load_transposed(grid, rows, column, tile_row);
  }
  for (; column * kTileColumns < rows.width; column += kColumnsPerWord) {
    load_two_tiles(grid, rows, column, tile_row);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto y = static_cast<Index>(i);
    load_edge(grid, rows, tile_row, y, grid.edges[0].top[i], grid.edges[1].top[i]);
    load_edge(grid, rows, tile_row, kTileRows - 1 - y, grid.edges[0].bottom[i],
              grid.edges[1].bottom[i]);
  }
  activate_occupied(grid, tile_row);
}

void store_rows(const TileGridView& grid, const BitPlaneView& rows, Index tile_row) {
  Index column = 0;
  if constexpr (kHasTranspose) {
    const Index end = transposed_columns(rows);
    for (; column < end; column += kTileLanes) store_transposed(grid, rows, column, tile_row);
  }
  for (; column * kTileColumns < rows.width; column += kColumnsPerWord) {
    store_two_tiles(grid, rows, column, tile_row);
  }
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const TileLayout Exported<TileLayout, kThisIsa>::kKernels = {kTileShape, &load_rows,
                                                                       &store_rows};

}  // namespace thinbench::detail
