#include "out_of_core/tiling.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "thinbench/options.hpp"

namespace thinbench {
namespace {

/// The part of a tile's side that its halo takes on each side. A deeper halo costs more, as it is
/// read and thinned twice; a shallower one takes more passes.
constexpr Index kHaloShare = 64;

constexpr Index round_down_to_bytes(Index pixels) {
  return pixels / 8 * 8;
}

constexpr Index round_up_to_bytes(Index pixels) {
  return packed_row_bytes(pixels) * 8;
}

/// What a row takes in memory: states add columns at both sides, which count in narrow images.
constexpr Index row_bytes_of_states(Index width) {
  return packed_row_bytes(width) + 16;
}

/// The side of the largest square of whole bytes that fits.
Index square_side(Index bytes) {
  return round_down_to_bytes(static_cast<Index>(std::sqrt(static_cast<double>(bytes) * 8)));
}

}  // namespace

Block Tiling::block(Index tile) const {
  const Index x = tile % columns() * tile_width;
  const Index y = tile / columns() * tile_height;
  return {x, y, std::min(tile_width, width - x), std::min(tile_height, height - y)};
}

Block Tiling::block_with_halo(Index tile) const {
  const Block inner = block(tile);
  const Index left = round_down_to_bytes(std::max<Index>(0, inner.x - halo));
  const Index top = std::max<Index>(0, inner.y - halo);
  const Index right = std::min(width, round_up_to_bytes(inner.x + inner.width + halo));
  const Index bottom = std::min(height, inner.y + inner.height + halo);
  return {left, top, right - left, bottom - top};
}

Index Tiling::max_block_bytes() const {
  const Index bytes_of_halo = packed_row_bytes(halo);
  const Index row = packed_row_bytes(std::min(width, tile_width)) + 2 * bytes_of_halo;
  return std::min(row, packed_row_bytes(width)) * std::min(height, tile_height + 2 * halo);
}

Tiling tiling_for(Index width, Index height, Index reach, Index block_bytes) {
  if (row_bytes_of_states(width) * height <= block_bytes) {
    return {width, height, round_up_to_bytes(width), height, 0, kUnlimited};
  }
  const Index side = square_side(block_bytes);
  const Index iterations = std::max<Index>(2, side / kHaloShare / reach);
  const Index halo = round_up_to_bytes(iterations * reach);
  Index tile_width = side - 2 * halo;
  Index tile_height = tile_width;
  if (width <= side) {  // tiles of whole rows, without a halo at their left and right
    tile_width = round_up_to_bytes(width);
    tile_height = block_bytes / row_bytes_of_states(width) - 2 * halo;
  } else if (height <= side) {
    tile_width = round_down_to_bytes(block_bytes / height * 8) - 2 * halo;
    tile_height = height;
  }
  if (tile_width < std::min(halo, width) || tile_height < std::min(halo, height)) {
    throw std::invalid_argument("blocks of " + std::to_string(block_bytes) +
                                " bytes are too small for tiles and their halo");
  }
  return {width, height, tile_width, tile_height, halo, static_cast<int>(iterations)};
}

std::vector<bool> with_neighbours(const Tiling& tiling, const std::vector<bool>& tiles) {
  std::vector<bool> found(tiles.size());
  const Index columns = tiling.columns();
  for (Index tile = 0; tile < tiling.count(); ++tile) {
    if (!tiles[static_cast<std::size_t>(tile)]) continue;
    const Index x = tile % columns;
    const Index y = tile / columns;
    for (Index row = std::max<Index>(0, y - 1); row <= std::min(tiling.rows() - 1, y + 1); ++row) {
      for (Index col = std::max<Index>(0, x - 1); col <= std::min(columns - 1, x + 1); ++col) {
        found[static_cast<std::size_t>(row * columns + col)] = true;
      }
    }
  }
  return found;
}

}  // namespace thinbench
