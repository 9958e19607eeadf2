#include <algorithm>

#include "compile/rule_body.hpp"
#include "core/exported.hpp"
#include "scan/built_in.hpp"

namespace thinbench::detail {
namespace {

/// As many sub-iterations as there are functions.
template <class Functions>
std::size_t count_of(const Functions& functions) {
  return static_cast<std::size_t>(std::find(functions.begin(), functions.end(), nullptr) -
                                  functions.begin());
}

BoundRule bind_built_in(BuiltInRule rule, Isa isa, Layout layout) {
  const BuiltInScans& kernels = kernels_of<BuiltInScans>(isa);
  const auto& scans = layout == Layout::row ? kernels.row : kernels.words;
  BoundRule bound;
  bound.register_elements = kernels.register_elements;
  bound.sub_iterations = count_of(kernels.words[rule]);
  if (layout == Layout::tiles) {
    bound.tile_passes = kernels_of<BuiltInTilePasses>(isa).by_rule[rule];
  } else if (layout == Layout::words || layout == Layout::row) {
    std::transform(scans[rule].begin(), scans[rule].end(), bound.scans.begin(),
                   [](ScanFunction scan) { return BoundScan{scan}; });
  } else {
    bound.repeat =
        kernels.lanes[static_cast<int>(layout) - static_cast<int>(Layout::lanes_32)][rule];
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
