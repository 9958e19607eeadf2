#include <algorithm>

#include "compile/rule_body.hpp"
#include "core/exported.hpp"
#include "scan/built_in.hpp"

namespace thinbench::detail {
namespace {

BoundRule bind_built_in(BuiltInRule rule, Isa isa, Layout layout) {
  const BuiltInScans& kernels = kernels_of<BuiltInScans>(isa);
  const TilePasses& tiles = kernels_of<BuiltInTilePasses>(isa).by_rule[rule];
  BoundRule bound;
  bound.register_elements = kernels.register_elements;
  bound.sub_iterations =
      static_cast<std::size_t>(std::find(tiles.begin(), tiles.end(), nullptr) - tiles.begin());
  if (layout == Layout::tiles) {
    bound.tile_passes = tiles;
  } else if (layout == Layout::row) {
    const ScanFunctions& scans = kernels.row[rule];
    std::transform(scans.begin(), scans.end(), bound.scans.begin(),
                   [](ScanFunction scan) { return BoundScan{scan}; });
  } else if (is_in_place(layout)) {
    const auto first = static_cast<int>(Layout::lanes_32);
    bound.repeat = kernels.lanes[static_cast<int>(layout) - first][rule];
  }
  return bound;
}

BoundRule bind_tables(const CompiledRule& rule, Isa isa, Layout layout, bool fixed) {
  BoundRule bound = rule.bind(isa, layout, fixed);
  for (std::size_t i = 0; layout == Layout::tiles && i < bound.sub_iterations; ++i) {
    if (bound.scans[i].function == nullptr) continue;
    bound.tile_passes[i] = kernels_of<BuiltInTilePasses>(isa).by_scan;
  }
  return bound;
}

}  // namespace

BoundRule bind(const SharedRule& rule, Isa isa, Layout layout, bool fixed) {
  BoundRule bound = rule->circuits ? bind_built_in(*rule->circuits, isa, layout)
                                   : bind_tables(*rule->compiled, isa, layout, fixed);
  bound.owner = rule;
  return bound;
}

bool holds_row(Isa isa) {
  return kernels_of<BuiltInScans>(isa).register_elements == kBlockWords;
}

}  // namespace thinbench::detail
