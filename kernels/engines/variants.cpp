#include "engines/variants.hpp"

#include "compile/machine_code.hpp"
#include "core/exported.hpp"
#include "engines/tile_passes.hpp"

namespace thinbench::detail {

bool has_fixed_pixels(const ThinningParameters& parameters) {
  return parameters.border == Border::keep || parameters.rule->adds_pixels();
}

std::vector<ThinningVariant> parallel_variants(bool built_in, bool adds_pixels) {
  ThinningVariants list;
  for (const Isa isa : isas_of<TileKernels>()) {
    if (!built_in) list.add_with_threads("simd_bitpacked", isa, &make_words, {kWordsPriority});
    if (built_in || (!adds_pixels && MachineCode::is_available(isa))) {
      list.add_with_threads("simd_bitpacked_tiles", isa, &make_tiles, {kTilesPriority});
    }
    if (holds_row(isa)) {
      list.add("simd_bitpacked_row", isa, &make_rows, {kRowPriority, kBlockWords * kWordBits});
    }
  }
  return list.take();
}

}  // namespace thinbench::detail
