// The state of a plan whose engine works on tiles.
#pragma once

#include <optional>
#include <vector>

#include "thinning/iteration/iterate_tiles.hpp"
#include "thinning/iteration/plane_state.hpp"

namespace thinbench::detail {

class TileState final : public ThinningState {
 public:
  TileState(const TileEngine& engine, const ThinningSetting& setting);

  /// A row of tiles at a time is packed and laid out while it is in the first cache, and back.
  int run(const ConstImageView& source, const ImageView& destination) override;

  /// The steps apart, over planes that the first load() makes: run() does without them, and they
  /// are two thirds of what it would need.
  void load(const ConstImageView& source) override;
  int thin() override;
  void store(const ImageView& destination) const override;

 private:
  /// Calls `body(tile_row, rows)` for every row of tiles, with room for its pixels.
  template <class Body>
  void for_tile_rows(const Body& body);

  TileEngine engine_;
  Isa isa_;
  Index width_;
  Index height_;
  int max_iterations_;
  BandTeam team_;
  const PlaneConversion<std::uint64_t>& conversion_;
  TileWorkspace workspace_;
  std::vector<BitPlane> rows_;  // of one row of tiles, for each thread
  std::optional<Planes<std::uint64_t>> planes_;
};

}  // namespace thinbench::detail
