#include "thinning/iterate_tiles.hpp"

#include <algorithm>
#include <bit>

namespace thinbench {
namespace {

/// A thread's share below which waiting for each other costs more than it saves.
constexpr Index kLeastShare = 512;

Index ring_capacity(Index width, Index height, const TileGridView& grid, int threads) {
  const Index ring = grid.strip_tiles + 2;
  const Index tiles =
      (round_up(width, kTileColumns) / kTileColumns) * (round_up(height, kTileRows) / kTileRows);
  const Index least = threads == 1 ? ring : std::max(ring, tiles);
  return static_cast<Index>(std::bit_ceil(static_cast<std::size_t>(least)));
}

/// Writes what is still pending of a range.
void commit(const TileGridView& grid, const TileVisits& visits) {
  for (Index i = std::max<Index>(0, visits.count - visits.capacity); i < visits.count; ++i) {
    const PendingTile& from = visits.pending[i & (visits.capacity - 1)];
    std::copy_n(from.words, kTileRows, grid.words + Index{visits.tiles[i]} * kTileRows);
  }
}

/// One step on all active tiles.
void visit_all(TileVisit visit, const RuleModel* model, Index active, TileWorkspace& workspace,
               ThreadTeam& team) {
  const TileGridView& grid = workspace.grid().view();
  const auto range = [&](Index first, Index last) {
    return TileVisits{grid.active + first, last - first, workspace.pending() + first,
                      workspace.capacity()};
  };
  if (team.threads() == 1 || active < team.threads() * kLeastShare) {
    visit(model, grid, range(0, active));
    commit(grid, range(0, active));
    return;
  }
  team.for_ranges(active, [&](Index first, Index last) { visit(model, grid, range(first, last)); });
  team.for_ranges(active, [&](Index first, Index last) { commit(grid, range(first, last)); });
}

}  // namespace

TileWorkspace::TileWorkspace(Index width, Index height, int threads)
    : grid_(width, height),
      capacity_(ring_capacity(width, height, grid_.view(), threads)),
      pending_(make_aligned<PendingTile>(static_cast<std::size_t>(capacity_))) {}

int iterate_tiles(const TileEngine& engine, const Conditions& conditions,
                  const ConstBitPlaneView& source, const BitPlaneView& target,
                  TileWorkspace& workspace, ThreadTeam& team) {
  TileGrid& grid = workspace.grid();
  const int length = static_cast<int>(engine.cycle.size());
  Index active = grid.load(source);
  int cycles = 0;
  do {
    for (int step = 0; step < length; ++step) {
      visit_all(engine.cycle[static_cast<std::size_t>(step)], conditions.model, active, workspace,
                team);
      active = (*engine.list_active)(grid.view(), step, length);
    }
    ++cycles;
  } while (active != 0 && cycles < conditions.most_cycles);
  grid.store(target);
  return cycles;
}

}  // namespace thinbench
