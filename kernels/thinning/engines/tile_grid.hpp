// Packed pixels in tiles of 16 rows by 32 columns, a register of 512 bits each, and which of them
// changed.
//
// Tiles lie in strips 32 columns wide, from the top down, so the rows above and below a word are
// the words before and after it. Every strip ends with at least one light tile, and a light strip
// lies on either side: no neighbour needs a condition.
#pragma once

#include <array>

#include "image/byte_image.hpp"
#include "image/layout.hpp"
#include "image/plane_view.hpp"
#include "thinbench/options.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

inline constexpr Index kTileRows = 16;
inline constexpr Index kTileColumns = 32;
/// Tiles whose flags are one word.
inline constexpr Index kTileGroup = 32;

struct TileGridView {
  Index strip_tiles;  // from a tile to its neighbour in the next strip
  Index groups;       // margins included

  std::uint32_t* words;  // row r of tile i is words[kTileRows * i + r], low bit first

  // What the last step changed, a bit a row of each tile: anywhere, in the first column, in the
  // last. Zero for tiles that it did not visit. May be read one strip and a group outside.
  std::uint16_t* changed_rows;
  std::uint16_t* changed_west;
  std::uint16_t* changed_east;

  const std::uint32_t* occupied;  // bit a tile: had dark pixels at the beginning
  /// Bit a tile: it or a pixel beside it changed in that step of the cycle.
  std::array<std::uint32_t*, kMaxSubIterations> wanted;
  const std::uint64_t* occupied_groups;  // bit a group: one of its tiles is occupied

  // Bit a tile: holds outermost pixels of the image, which keep their values. nullptr where all
  // pixels may change.
  const std::uint32_t* border_tiles;
  Index width;
  Index height;
};

/// Owns a grid. No allocation after construction.
class TileGrid {
 public:
  TileGrid(Index width, Index height, Border border);

  [[nodiscard]] const TileGridView& view() const { return view_; }

  /// Rows of tiles.
  [[nodiscard]] Index tile_rows() const { return tile_rows_; }
  /// Words of a bit set with a bit a group.
  [[nodiscard]] Index group_words() const { return (view_.groups + kWordBits - 1) / kWordBits; }

  /// After all rows were loaded, see TileLayout: lists the tiles with dark pixels, ascending, in
  /// `list`, which has room for all tiles, and sets the bits of their groups in `visited`. Returns
  /// how many.
  Index begin(std::uint32_t* list, std::uint64_t* visited);

 private:
  void mark_border_tiles();
  void find_occupied();
  Index list_occupied(std::uint32_t* list);

  Index strips_;
  Index tile_rows_;
  TileGridView view_;
  AlignedArray<std::uint32_t> words_;
  std::array<AlignedArray<std::uint16_t>, 3> changed_;
  AlignedArray<std::uint32_t> occupied_;
  AlignedArray<std::uint32_t> wanted_;
  AlignedArray<std::uint32_t> border_tiles_;
  AlignedArray<std::uint64_t> occupied_groups_;
};

}  // namespace thinbench::detail
