// Tiles in the registers of an ISA. For ISA files only.
#pragma once

#include "engines/tile_grid.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Index kTileLanes = static_cast<Index>(Lanes32::size);  // a row of a tile in each

/// Of 32 rows, a quarter more pixels are visited than of 16, with fewer visits. That pays only in
/// registers of 16 lanes: docs/experiments.md#tiles.
inline constexpr Index kTileRows = kTileLanes == 16 ? 32 : 16;
inline constexpr Index kTileRegisters = kTileRows / kTileLanes;
inline constexpr TileShape kTileShape = {kTileRows, kTileLanes};

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
