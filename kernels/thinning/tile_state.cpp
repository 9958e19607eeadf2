#include "thinning/tile_state.hpp"

#include <algorithm>

namespace thinbench {
namespace {

template <class View>
View rows_of_tiles(const View& view, Index tile_row) {
  const Index first = tile_row * kTileRows;
  return rows_of_view(view, first, std::min(first + kTileRows, view.height));
}

}  // namespace

TileState::TileState(const TileEngine& engine, const TileSetting& setting)
    : PlaneState(setting.isa, setting.width, setting.height, setting.threads),
      engine_(engine),
      setting_(setting),
      workspace_(setting.width, setting.height, setting.threads) {
  for (int i = 0; i < setting.threads; ++i) bands_.emplace_back(setting.width, kTileRows);
}

int TileState::thin() {
  const TileGrid& grid = workspace_.grid();
  const TileLayout& layout = *engine_.layout;
  const ConstBitPlaneView from = source();
  const BitPlaneView to = planes.result.view();
  for_bands(grid.tile_rows(), [&](Index first, Index last) {
    for (Index row = first; row < last; ++row)
      layout.load_rows(grid.view(), rows_of_tiles(from, row), row);
  });
  const int cycles = iterate_tiles(engine_, setting_.most_cycles, workspace_, team);
  for_bands(grid.tile_rows(), [&](Index first, Index last) {
    for (Index row = first; row < last; ++row)
      layout.store_rows(grid.view(), rows_of_tiles(to, row), row);
  });
  return cycles;
}

template <class Body>
void TileState::for_tile_rows(const Body& body) {
  std::atomic<std::size_t> next = 0;
  for_bands(workspace_.grid().tile_rows(), [&](Index first, Index last) {
    BitPlaneView band = bands_[next++].view();
    for (Index row = first; row < last; ++row) {
      band.height = std::min(kTileRows, setting_.height - row * kTileRows);
      body(row, band);
    }
  });
}

int TileState::run(const ConstByteView& source, const ByteView& destination) {
  const TileGridView& grid = workspace_.grid().view();
  for_tile_rows([&](Index row, const BitPlaneView& rows) {
    planes.conversion.read(rows_of_tiles(source, row), rows);
    engine_.layout->load_rows(grid, rows, row);
  });
  const int cycles = iterate_tiles(engine_, setting_.most_cycles, workspace_, team);
  const bool is_large = setting_.width * setting_.height >= kStreamedBytes;
  const auto write = is_large ? planes.conversion.write_streamed : planes.conversion.write;
  for_tile_rows([&](Index row, const BitPlaneView& rows) {
    engine_.layout->store_rows(grid, rows, row);
    write(rows, rows_of_tiles(destination, row));
  });
  return cycles;
}

}  // namespace thinbench
