// The state of the tile engine.
#pragma once

#include <optional>
#include <vector>

#include "thinning/iteration/iterate_tiles.hpp"
#include "thinning/iteration/plane_state.hpp"

namespace thinbench::detail {

class TileState final : public ThinningState {
 public:
  TileState(const TileEngine& engine, const ThinningSetting& setting);

  /// Packs and lays out one row of tiles at a time, while it is in the first-level cache, and back.
  int run(const ConstImageView& source, const ImageView& destination) override;

  /// The steps by themselves need planes, which the first load() allocates. Without them run()
  /// takes a third of the memory.
  void load(const ConstImageView& source) override;
  int thin() override;
  void store(const ImageView& destination) const override;

 private:
  /// Calls `body(tile_row, rows)` for every row of tiles, with memory for its pixels.
  template <class Body>
  void for_tile_rows(const Body& body);

  TileEngine engine_;
  ThinningSetting setting_;
  BandTeam team_;
  const PlaneConversion<std::uint64_t>& conversion_;
  TileWorkspace workspace_;
  std::vector<BitPlane> rows_;  // of one row of tiles, by thread
  std::optional<Planes<std::uint64_t>> planes_;
};

}  // namespace thinbench::detail
