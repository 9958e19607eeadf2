// Packed pixels in tiles of 32 rows by 32 columns, or of 16 rows with registers of less than 512
// bits, and which of them changed.
//
// Rows of tiles are stored one after the other, with a background tile before and after each.
// Registers of a tile hold every n-th of its rows, so a row's neighbours above and below are in
// other registers, in the same lanes. The first and last row of every tile are also kept apart:
// what a tile needs of the rows of tiles above and below lies side by side there.
#pragma once

#include <array>

#include "core/byte_image.hpp"
#include "core/layout.hpp"
#include "core/plane_view.hpp"
#include "scan/bound_rule.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

inline constexpr Index kTileColumns = 32;

/// What an ISA makes of tiles. Grids are for the kernels of one shape.
struct TileShape {
  Index rows;
  Index lanes;  // of a register, each of which holds a row

  /// Where row `y` is among the words of a tile: in register y modulo the number of registers.
  [[nodiscard]] constexpr Index word_of_row(Index y) const {
    const Index registers = rows / lanes;
    return y % registers * lanes + y / registers;
  }
};

/// The outermost rows of all tiles, by tile: [0] is the first or last row, [1] the next one, which
/// two-stage rules read.
struct TileEdges {
  std::array<std::uint32_t*, 2> top;
  std::array<std::uint32_t*, 2> bottom;
};

/// Bit sets of the tiles next to, or with, a pixel that changed in a sub-iteration, by where the
/// pixel is: in the same row of tiles, or in the one below or above.
struct TileChanges {
  std::uint64_t* here;
  std::uint64_t* below;  // bits of row r are of tiles in row r - 1
  std::uint64_t* above;  // of tiles in row r + 1
};

/// What a visit changed, a byte per tile with a bit per lane of a register. Not used with 16 lanes.
struct ChangedLanes {
  std::uint8_t* any;    // of all registers; not used with two, the first and the last
  std::uint8_t* west;   // in the first column
  std::uint8_t* east;   // in the last column
  std::uint8_t* first;  // of the first register: bit 0 is the first row of the tile
  std::uint8_t* last;   // of the last register: the last bit is the last row
};

struct TileGridView {
  Index width;
  Index height;
  TileShape shape;
  Index tile_rows;
  Index stride;  // tiles from a tile to the one below it; tiles beside it are next to it

  std::uint32_t* words;  // tile i is at words[shape.rows * i]; the low bit is westernmost
  /// A sub-iteration reads one and writes the other, for the tiles that it visits. Those that it
  /// changes are visited by the next one, too, so both agree on all other tiles.
  std::array<TileEdges, 2> edges;
  /// The same by the tile that reads them: above the top edge or below the bottom edge. Kept, not
  /// computed, as loops over tiles are short of registers.
  std::array<TileEdges, 2> neighbours;

  ChangedLanes changed_lanes;

  // Bit sets of tiles, in `row_words` words per row of tiles. Bit 0 of a row is the background tile
  // before it, which has number first_tiles[word]; a background tile after it has a bit, too.
  Index row_words;
  const std::uint32_t* first_tiles;  // the tile of bit 0, by word
  std::uint64_t* occupied;           // with foreground in the input
  std::uint64_t* active;             // to be visited
  const std::uint64_t* border;       // with pixels that must not change; nullptr if there are none
  std::array<std::uint64_t*, kMaxSubIterations> near;  // changes of all rows, by sub-iteration
  std::array<TileChanges, 2> changes;  // of the last sub-iteration and of this one, in turn

  /// The number of the tile in the first column.
  [[nodiscard]] Index first_tile(Index tile_row) const { return tile_row * stride + 1; }
  [[nodiscard]] Index first_word(Index tile_row) const { return tile_row * row_words; }
};

/// Owns a grid. Allocates only in the constructor.
class TileGrid {
 public:
  TileGrid(Index width, Index height, Border border, const TileShape& shape);

  /// Whether 31 bits number the tiles of such an image and those next to them.
  [[nodiscard]] static bool fits(Index width, Index height, const TileShape& shape);

  [[nodiscard]] const TileGridView& view() const { return view_; }

 private:
  void mark_border_tiles(std::uint64_t* border);

  Index columns_;
  TileGridView view_;
  AlignedArray<std::uint32_t> words_;
  AlignedArray<std::uint32_t> edges_;
  AlignedArray<std::uint32_t> first_tiles_;
  AlignedArray<std::uint8_t> changed_lanes_;
  AlignedArray<std::uint64_t> sets_;
};

}  // namespace thinbench::detail
