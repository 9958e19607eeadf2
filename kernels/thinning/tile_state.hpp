// The state of a plan whose engine works on tiles.
#pragma once

#include <atomic>
#include <vector>

#include "thinning/iterate_tiles.hpp"
#include "thinning/state.hpp"

namespace thinbench {

struct TileSetting {
  Isa isa;
  Index width;
  Index height;
  int threads;
  int most_cycles;
};

class TileState final : public PlaneState<std::uint64_t> {
 public:
  TileState(const TileEngine& engine, const TileSetting& setting);

  int thin() override;

  /// Without the planes: a row of tiles at a time is packed and laid out while it is in the first
  /// cache, and back.
  int run(const ConstByteView& source, const ByteView& destination) override;

 private:
  /// Calls `body(tile_row, rows)` for every row of tiles, with room for its pixels.
  template <class Body>
  void for_tile_rows(const Body& body);

  TileEngine engine_;
  TileSetting setting_;
  TileWorkspace workspace_;
  std::vector<BitPlane> bands_;  // one a thread
};

}  // namespace thinbench
