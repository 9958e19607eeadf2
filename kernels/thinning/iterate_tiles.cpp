#include "thinning/iterate_tiles.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace thinbench {
namespace {

/// A thread's share below which waiting for each other costs more than it saves.
constexpr Index kLeastShare = 512;

/// Tiles that wait to be written. Two more than needed: the next write is then not a multiple of
/// 4096 bytes away from what is read meanwhile.
Index kept_tiles(const TileGridView& grid, int threads) {
  const Index beside = grid.strip_tiles + 4;
  return threads == 1 ? beside : std::max(beside, grid.groups * kTileGroup);
}

/// Writes what is still pending of a range.
void commit(const TileGridView& grid, const TileVisits& visits) {
  for (Index i = std::max<Index>(0, visits.count - visits.kept); i < visits.count; ++i) {
    const PendingTile& from = visits.pending[i & (visits.ring - 1)];
    std::memcpy(grid.words + Index{visits.tiles[i]} * kTileRows, from.words, sizeof(from.words));
  }
}

/// One step on all active tiles.
void visit_all(TileVisit visit, Index active, TileWorkspace& workspace, const ThreadTeam& team) {
  const TileGridView& grid = workspace.grid().view();
  const auto range = [&](Index first, Index last) {
    return TileVisits{grid.active + first, last - first, workspace.pending() + first,
                      workspace.kept(), workspace.ring()};
  };
  if (team.threads() == 1 || active < team.threads() * kLeastShare) {
    visit(grid, range(0, active));
    commit(grid, range(0, active));
    return;
  }
  team.for_ranges(active, [&](Index first, Index last) { visit(grid, range(first, last)); });
  team.for_ranges(active, [&](Index first, Index last) { commit(grid, range(first, last)); });
}

}  // namespace

TileWorkspace::TileWorkspace(Index width, Index height, int threads)
    : grid_(width, height),
      kept_(kept_tiles(grid_.view(), threads)),
      ring_(static_cast<Index>(std::bit_ceil(static_cast<std::size_t>(kept_)))),
      pending_(make_aligned<PendingTile>(static_cast<std::size_t>(ring_))) {}

int iterate_tiles(const TileEngine& engine, int most_cycles, const ConstBitPlaneView& source,
                  const BitPlaneView& target, TileWorkspace& workspace, const ThreadTeam& team) {
  TileGrid& grid = workspace.grid();
  const ThreadTeam alone(1);
  const ThreadTeam& sharing =
      grid.view().groups * kTileGroup < team.threads() * kLeastShare ? alone : team;
  const int length = static_cast<int>(engine.cycle.size());
  Index active = grid.load(source, sharing);
  int cycles = 0;
  do {
    for (int step = 0; step < length; ++step) {
      visit_all(engine.cycle[static_cast<std::size_t>(step)], active, workspace, team);
      active = (*engine.list_active)(grid.view(), step, length);
    }
    ++cycles;
  } while (active != 0 && cycles < most_cycles);
  grid.store(target, sharing);
  return cycles;
}

}  // namespace thinbench
