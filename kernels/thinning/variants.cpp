#include "thinning/variants.hpp"

#include "dispatch/exported.hpp"
#include "thinning/engines/spta.hpp"
#include "thinning/iteration/pass_state.hpp"
#include "thinning/iteration/row_state.hpp"
#include "thinning/iteration/tile_state.hpp"

namespace thinbench::detail {
namespace {

using enum Technique;
using State = std::unique_ptr<ThinningState>;

template <class T>
State make_passes(const PassesByRule<T>& passes, const ThinningSetting& setting) {
  return std::make_unique<PassState<T>>(passes[setting.rule].functions(), setting);
}

State make_lut(const ThinningSetting& setting) {
  return make_passes(ScalarPasses::kLut, setting);
}
State make_lut_sliding(const ThinningSetting& setting) {
  return make_passes(ScalarPasses::kLutSliding, setting);
}
State make_autovec(const ThinningSetting& setting) {
  return make_passes(kernels_of<AutovecPasses>(setting.isa).bytes, setting);
}
State make_bytes(const ThinningSetting& setting) {
  return make_passes(kernels_of<SimdPasses>(setting.isa).bytes, setting);
}

State make_tiles(const ThinningSetting& setting) {
  const TileKernels& kernels = kernels_of<TileKernels>(setting.isa);
  return std::make_unique<TileState>(TileEngine{kernels.by_rule[setting.rule].functions(), &kernels,
                                                &kernels_of<TileLayout>(setting.isa)},
                                     setting);
}

class SptaState final : public PlaneState<std::uint64_t> {
 public:
  explicit SptaState(const ThinningSetting& setting)
      : PlaneState(setting),
        border_(setting.border),
        max_iterations_(setting.max_iterations),
        scratch_(make_aligned<std::uint64_t>(
            static_cast<std::size_t>(spta_scratch_words(setting.width, setting.height)))) {}

  int thin() override {
    return thin_spta(border_, max_iterations_, source(), planes.result.view(), scratch_.get());
  }

 private:
  Border border_;
  int max_iterations_;
  AlignedArray<std::uint64_t> scratch_;
};

State make_spta(const ThinningSetting& setting) {
  return std::make_unique<SptaState>(setting);
}

}  // namespace

State make_bitpacked(const ThinningSetting& setting) {
  return make_passes(ScalarPasses::kBitpacked, setting);
}

State make_simd_bitpacked(const ThinningSetting& setting) {
  return make_passes(kernels_of<SimdPasses>(setting.isa).bitpacked, setting);
}

State make_row(const ThinningSetting& setting) {
  return std::make_unique<RowState>(kernels_of<RowKernels>(setting.isa).by_rule[setting.rule],
                                    setting);
}

bool is_parallel_rule(Rule rule) {
  return !ScalarPasses::kBitpacked[rule].empty();
}

std::vector<ThinningVariant> parallel_rule_variants(Rule rule) {
  ThinningVariants list;
  if (!ScalarPasses::kLut[rule].empty()) {
    list.add_with_threads(lut, Isa::baseline, &make_lut, {kLutPriority});
    list.add(lut_sliding, Isa::baseline, &make_lut_sliding, {kLutSlidingPriority});
  }
  list.add_with_threads(bitpacked, Isa::baseline, &make_bitpacked, {kBitpackedPriority});
  for (const Isa isa : all_isas()) {
    list.add(autovec, isa, &make_autovec, {kAutovecPriority});
    list.add(simd_bytes, isa, &make_bytes, {kBytesPriority});
    list.add_with_threads(simd_bitpacked, isa, &make_simd_bitpacked, {kSimdBitpackedPriority});
    list.add_with_threads(simd_bitpacked_tiles, isa, &make_tiles, {kTilesPriority});
    if (kernels_of<RowKernels>(isa).by_rule[rule] != nullptr) {
      list.add(simd_bitpacked_row, isa, &make_row, {kRowPriority, kRowKernelWidth});
    }
  }
  return list.take();
}

std::vector<ThinningVariant> spta_variants() {
  ThinningVariants list;
  list.add(bitpacked, Isa::baseline, &make_spta, {kBitpackedPriority});
  return list.take();
}

}  // namespace thinbench::detail
