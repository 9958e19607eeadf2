#include "localise/state.hpp"

#include "dispatch/exported.hpp"
#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

std::unique_ptr<LocaliseState> make_bitpacked(const LocaliseSetting& setting) {
  return std::make_unique<LocaliseState>(kBitpackedRunEngine.holes, setting);
}

std::unique_ptr<LocaliseState> make_simd(const LocaliseSetting& setting) {
  return std::make_unique<LocaliseState>(kernels_of<RunEngine>(setting.isa).holes, setting);
}

}  // namespace

LocaliseState::LocaliseState(LabelRows label_rows, const LocaliseSetting& setting)
    : edges_({setting.op, setting.thresholds, setting.isa, setting.width, setting.height,
              setting.threads}),
      outlined_(setting.width, setting.height),
      objects_(setting.width, setting.height),
      regions_(label_rows, setting.width, setting.height, setting.threads) {}

RegionLists LocaliseState::run(const ConstImageView& source) {
  outlined_.write(edges_.run(source), objects_.view());
  return regions_.label(objects_.view());
}

std::vector<LocaliseVariant> localise_variants() {
  VariantList<LocaliseState> list;
  list.add_with_threads(Technique::bitpacked_runs, Isa::baseline, &make_bitpacked, {0});
  for (const Isa isa : all_isas()) {
    list.add_with_threads(Technique::simd_runs, isa, &make_simd, {1, kSimdRunsWidth});
  }
  return list.take();
}

}  // namespace thinbench::detail
