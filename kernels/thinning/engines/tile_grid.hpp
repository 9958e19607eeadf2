// Packed pixels in tiles of 16 rows by 32 columns, 512 bits each, and which of them changed.
//
// Tiles are stored in strips 32 columns wide, from the top down, so the rows above and below a word
// are the words before and after it. Every strip ends with at least one background tile, and there
// is a background strip on either side: no neighbour needs a condition.
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
/// The flags of a group of tiles are one word.
inline constexpr Index kTileGroup = 32;

struct TileGridView {
  Index strip_tiles;  // the distance from a tile to its neighbour in the next strip
  Index groups;       // margins included

  std::uint32_t* words;  // row r of tile i is words[kTileRows * i + r], low bit first

  // What the last sub-iteration changed, one bit per row of each tile: anywhere, in the first
  // column, in the last. Zero for tiles that were not visited. Readable one strip and a group
  // outside.
  std::uint16_t* changed_rows;
  std::uint16_t* changed_west;
  std::uint16_t* changed_east;

  // Bit sets by tile or by group of tiles.
  const std::uint32_t* occupied;  // has foreground at the beginning
  /// By sub-iteration: the tile or a pixel beside it changed.
  std::array<std::uint32_t*, kMaxSubIterations> wanted;
  const std::uint64_t* occupied_groups;  // one of its tiles is occupied
  /// Has outermost pixels of the image, which must not change; nullptr where all pixels may.
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
  /// Words of a bit set by group.
  [[nodiscard]] Index group_words() const { return (view_.groups + kWordBits - 1) / kWordBits; }

  /// After all rows were loaded, see TileLayout: lists the tiles with foreground in ascending order
  /// in `list`, which has room for all tiles, sets the bits of their groups in `visited`, and
  /// returns their number.
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
