// Packed pixels in tiles of 16 rows by 32 columns (512 bits), and which of their rows changed.
//
// Tiles are stored in vertical strips 32 columns wide, so the words before and after a word are its
// neighbours above and below. Every strip ends with at least one background tile, and there is a
// background strip on either side, so that no neighbour access needs a condition.
#pragma once

#include <array>

#include "core/byte_image.hpp"
#include "core/layout.hpp"
#include "core/plane_view.hpp"
#include "scan/bound_rule.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

inline constexpr Index kTileRows = 16;
inline constexpr Index kTileColumns = 32;
/// A group is the tiles that share a word of a bit set.
inline constexpr Index kTileGroup = 32;

struct TileGridView {
  Index strip_tiles;  // the distance between horizontally adjacent tiles
  Index groups;       // margins included

  std::uint32_t* words;  // row r of tile i is words[kTileRows * i + r]; the low bit is westernmost

  // The rows of each tile that the last sub-iteration changed, as bits: in any column, in the first
  // column, in the last column. Zero for tiles that were not visited. Readable up to one strip and
  // one group beyond both ends.
  std::uint16_t* changed_rows;
  std::uint16_t* changed_west;
  std::uint16_t* changed_east;

  // Bit sets of tiles or groups.
  const std::uint32_t* occupied;  // tiles with foreground in the input
  /// By sub-iteration: tiles in which, or next to which, a pixel changed.
  std::array<std::uint32_t*, kMaxSubIterations> changed_near;
  const std::uint64_t* occupied_groups;  // groups with an occupied tile
  /// Tiles with border pixels, which must not change; nullptr if all pixels may change.
  const std::uint32_t* border_tiles;
  Index width;
  Index height;
};

/// Owns a grid. Allocates only in the constructor.
class TileGrid {
 public:
  TileGrid(Index width, Index height, Border border);

  /// Whether 32 bits number the tiles of such an image and those next to them.
  [[nodiscard]] static bool fits(Index width, Index height);

  [[nodiscard]] const TileGridView& view() const { return view_; }

  /// The number of rows of tiles.
  [[nodiscard]] Index tile_rows() const { return tile_rows_; }
  /// The number of 64-bit words of a bit set of groups.
  [[nodiscard]] Index group_words() const { return (view_.groups + kWordBits - 1) / kWordBits; }

  /// Clears the history. Call after all rows are loaded (see TileLayout). Writes the occupied tiles
  /// to `list`, which has room for all tiles, in ascending order, and the bit set of their groups
  /// to `visited`; returns the number of tiles.
  Index restart(std::uint32_t* list, std::uint64_t* visited);

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
  AlignedArray<std::uint32_t> changed_near_;
  AlignedArray<std::uint32_t> border_tiles_;
  AlignedArray<std::uint64_t> occupied_groups_;
};

}  // namespace thinbench::detail
