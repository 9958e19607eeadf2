// The state of the tile engine.
#pragma once

#include <vector>

#include "engines/iterate_tiles.hpp"
#include "engines/plane_state.hpp"

namespace thinbench::detail {

class TileState final : public ThinningState {
 public:
  TileState(TileEngine engine, const ThinningSetting& setting);

  /// Converts one row of tiles at a time, so that its packed rows stay in the L1 cache.
  int run(const ConstImageView& source, const ImageView& destination) override;
  int run(const ConstPackedView& source, const PackedView& destination) override;

 private:
  /// Thins rows of tiles that `read(source_rows, rows)` fills and `write(tile_row, rows)` takes.
  /// One thread runs the first sub-iterations on rows of tiles while they are in a near cache. That
  /// gains nothing if the image is there, too.
  template <class Source, class Read, class Write>
  int run_by_tile_rows(const Source& source, const Read& read, const Write& write);
  /// A buffer for the pixels of a row of tiles.
  BitPlaneView buffer(std::size_t band, Index tile_row);
  /// Calls `body(tile_row, rows)` for every row of tiles. `rows` is its buffer().
  template <class Body>
  void for_tile_rows(const Body& body);

  TileEngine engine_;
  ThinningSetting setting_;
  BandTeam team_;
  const PlaneConversion<std::uint64_t>& conversion_;
  TileWorkspace workspace_;
  std::vector<BitPlane> rows_;  // one row of tiles per thread
};

}  // namespace thinbench::detail
