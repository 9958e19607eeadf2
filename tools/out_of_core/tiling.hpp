// How an image larger than memory is divided into tiles, and what a tile must read around itself.
#pragma once

#include <cstdint>
#include <vector>

#include "images/packed_file.hpp"

namespace thinbench {

/// Tiles of one size, those at the right and at the bottom are cut off. A pass advances every tile
/// by `iterations` iterations. For that it reads a halo of `halo` pixels, at least `iterations`
/// times the rule's reach (RuleInfo) and at most a tile's side: what is wrong at the edge of the
/// halo does not reach the tile, and what a tile of the next pass depends on is in its eight
/// neighbours.
struct Tiling {
  Index width = 0;  // of the image
  Index height = 0;
  Index tile_width = 0;  // a multiple of 8
  Index tile_height = 0;
  Index halo = 0;
  int iterations = 0;

  [[nodiscard]] Index columns() const { return (width + tile_width - 1) / tile_width; }
  [[nodiscard]] Index rows() const { return (height + tile_height - 1) / tile_height; }
  [[nodiscard]] Index count() const { return columns() * rows(); }

  [[nodiscard]] Block block(Index tile) const;
  /// The tile with its halo, clipped to the image.
  [[nodiscard]] Block block_with_halo(Index tile) const;
  /// The maximum number of bytes of a tile with its halo.
  [[nodiscard]] Index max_block_bytes() const;
};

/// A tiling whose tiles with halo take at most `block_bytes` bytes; a single tile without a halo if
/// the image does. Throws std::invalid_argument if that is too little for any tiling.
[[nodiscard]] Tiling tiling_for(Index width, Index height, Index reach, Index block_bytes);

/// The tiles marked and their eight neighbours.
[[nodiscard]] std::vector<bool> with_neighbours(const Tiling& tiling,
                                                const std::vector<bool>& tiles);

}  // namespace thinbench
