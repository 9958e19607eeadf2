#include "engines/tile_state.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/exported.hpp"
#include "engines/variants.hpp"

namespace thinbench::detail {
namespace {

template <class View>
View rows_of_tiles(const View& view, const TileGridView& grid, Index tile_row) {
  const Index first = tile_row * grid.shape.rows;
  return rows_of_view(view, first, std::min(first + grid.shape.rows, view.height));
}

Index row_bytes(const ConstImageView& view) {
  return view.width;
}

Index row_bytes(const ConstPackedView& view) {
  return packed_row_bytes(view.width);
}

/// The bytes from the first row to the last, or none if most of them are between rows.
template <class View>
ConstBytes memory_of(const View& rows) {
  if (rows.stride > 2 * row_bytes(rows)) return {};
  return {rows.data, (rows.height - 1) * rows.stride + row_bytes(rows)};
}

}  // namespace

TileState::TileState(TileEngine engine, const ThinningSetting& setting)
    : engine_(std::move(engine)),
      setting_(setting),
      team_(setting.width, setting.height, setting.threads),
      conversion_(plane_conversion<std::uint64_t>(setting.isa)),
      workspace_(setting.width, setting.height, setting.border, team_.threads().threads(),
                 engine_.layout->shape) {
  const TileShape& shape = workspace_.grid().shape;
  const Index tile_rows = std::max<Index>(1, workspace_.grid().tile_rows);
  const auto bands =
      static_cast<std::size_t>(std::min<Index>(team_.threads().threads(), tile_rows));
  rows_.reserve(bands);
  while (rows_.size() < bands) rows_.emplace_back(setting.width, shape.rows);
}

BitPlaneView TileState::buffer(std::size_t band, Index tile_row) {
  BitPlaneView rows = rows_[band].view();
  const Index first = tile_row * workspace_.grid().shape.rows;
  rows.height = std::min(rows.height, setting_.height - first);
  return rows;
}

template <class Body>
void TileState::for_tile_rows(const Body& body) {
  std::atomic<std::size_t> next = 0;
  team_.for_bands(workspace_.grid().tile_rows, [&](Index first, Index last) {
    const std::size_t band = next++;
    for (Index row = first; row < last; ++row) body(row, buffer(band, row));
  });
}

template <class Source, class Read, class Write>
int TileState::run_by_tile_rows(const Source& source, const Read& read, const Write& write) {
  const TileGridView& grid = workspace_.grid();
  const auto source_rows = [&](Index row) { return rows_of_tiles(source, grid, row); };
  const auto load = [&](Index row, const BitPlaneView& rows) {
    read(source_rows(row), rows);
    if (setting_.complemented) complement(rows);
    engine_.layout->load_rows(grid, rows, row);
  };
  TileIteration iteration(engine_, workspace_, team_.threads());
  if (team_.threads().threads() == 1 && team_.is_large()) {
    iteration.run_while_loading([&](Index row) { load(row, buffer(0, row)); },
                                [&](Index row) { return memory_of(source_rows(row)); });
  } else {
    for_tile_rows(load);
  }
  const int iterations = iteration.run(setting_.max_iterations);
  for_tile_rows([&](Index row, const BitPlaneView& rows) {
    engine_.layout->store_rows(grid, rows, row);
    if (setting_.complemented) complement(rows);
    write(row, rows);
  });
  return iterations;
}

int TileState::run(const ConstImageView& source, const ImageView& destination) {
  const auto write = row_writer(conversion_, setting_.width * setting_.height);
  return run_by_tile_rows(source, conversion_.read, [&](Index row, const BitPlaneView& from) {
    write(from, rows_of_tiles(destination, workspace_.grid(), row));
  });
}

int TileState::run(const ConstPackedView& source, const PackedView& destination) {
  const auto read = [](const ConstPackedView& rows, const BitPlaneView& to) {
    read_packed(rows, to);
  };
  return run_by_tile_rows(source, read, [&](Index row, const BitPlaneView& from) {
    write_packed(from, rows_of_tiles(destination, workspace_.grid(), row));
  });
}

std::unique_ptr<ThinningState> make_tiles(const ThinningSetting& setting) {
  const TileLayout& layout = kernels_of<TileLayout>(setting.isa);
  if (!TileGrid::fits(setting.width, setting.height, layout.shape)) return make_words(setting);
  BoundRule rule = bind(setting.rule, setting.isa, Layout::tiles, false);
  for (std::size_t i = 0; i < rule.sub_iterations; ++i) {
    if (rule.tile_passes[i] == nullptr) return make_words(setting);
  }
  return std::make_unique<TileState>(
      TileEngine{std::move(rule), &kernels_of<TileKernels>(setting.isa), &layout}, setting);
}

}  // namespace thinbench::detail
