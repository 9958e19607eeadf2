#include "compile/rule_body.hpp"
#include "core/exported.hpp"
#include "scan/built_in.hpp"

namespace thinbench::detail {
namespace {

BoundRule bind_built_in(BuiltInRule rule, Isa isa, Layout layout) {
  const BuiltInScans& kernels = kernels_of<BuiltInScans>(isa);
  BoundRule bound;
  bound.register_elements = kernels.register_elements;
  if (layout == Layout::tiles) {
    bound.tile_passes = kernels_of<BuiltInTilePasses>(isa).by_rule[rule];
    while (bound.sub_iterations < kMaxSubIterations &&
           bound.tile_passes[bound.sub_iterations] != nullptr) {
      ++bound.sub_iterations;
    }
    return bound;
  }
  for (const ScanFunction scan : kernels.by_layout[static_cast<std::size_t>(layout)][rule]) {
    if (scan != nullptr) bound.scans[bound.sub_iterations++] = {scan};
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
