// Packed pixels in tiles of 16 rows by 32 columns, a register of 512 bits each, and which of them
// changed.
//
// Tiles lie in strips 32 columns wide, from the top down, so the rows above and below a word are
// the words before and after it. Every strip ends with at least one light tile, and a light strip
// lies on either side: no neighbour needs a condition.
#pragma once

#include <array>
#include <vector>

#include "core/image.hpp"
#include "core/layout.hpp"
#include "core/thread_team.hpp"
#include "core/views.hpp"

namespace thinbench {

inline constexpr Index kTileRows = 16;
inline constexpr Index kTileColumns = 32;
/// Tiles whose flags are one word.
inline constexpr Index kTileGroup = 32;

struct TileGridView {
  static constexpr int kLongestCycle = 4;

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
  std::array<std::uint32_t*, kLongestCycle> wanted;
  const std::uint64_t* occupied_groups;  // bit a group: one of its tiles is occupied
  std::uint64_t* visited;                // bit a group: tiles of it are in the list
  std::uint64_t* candidates;             // room for as many
  std::uint32_t* active;                 // the list: ascending
};

/// Owns a grid. No allocation after construction.
class TileGrid {
 public:
  TileGrid(Index width, Index height);

  [[nodiscard]] const TileGridView& view() const { return view_; }

  /// Takes the pixels of `plane`; all tiles with dark ones are active. Returns how many.
  Index load(const ConstBitPlaneView& plane, const ThreadTeam& team);
  void store(const BitPlaneView& plane, const ThreadTeam& team) const;

 private:
  [[nodiscard]] Index tile_at(Index strip, Index row) const {
    return (strip + 1) * view_.strip_tiles + row;
  }
  void load_tile(const ConstBitPlaneView& plane, Index strip, Index row);
  void find_occupied();
  Index list_occupied();

  Index strips_;
  Index tile_rows_;
  TileGridView view_;
  AlignedArray<std::uint32_t> words_;
  std::array<AlignedArray<std::uint16_t>, 3> changed_;
  AlignedArray<std::uint32_t> occupied_;
  AlignedArray<std::uint32_t> wanted_;
  AlignedArray<std::uint64_t> groups_;
  AlignedArray<std::uint32_t> active_;
};

}  // namespace thinbench
