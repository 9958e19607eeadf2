#include "localise/state.hpp"

#include "core/exported.hpp"
#include "regions/variants.hpp"

namespace thinbench::detail {
namespace {

std::unique_ptr<LocaliseState> make_bitpacked(const LocaliseSetting& setting) {
  return std::make_unique<LocaliseState>(kBitpackedRunEngine, setting);
}

std::unique_ptr<LocaliseState> make_simd(const LocaliseSetting& setting) {
  return std::make_unique<LocaliseState>(kernels_of<RunEngine>(setting.isa), setting);
}

}  // namespace

LocaliseState::LocaliseState(const RunEngine& engine, const LocaliseSetting& setting)
    : edges_(setting),
      outlined_(setting.width, setting.height),
      objects_(setting.width, setting.height),
      regions_(engine, true, setting.isa, setting.width, setting.height, setting.threads) {}

RegionLists LocaliseState::run(const ConstImageView& source) {
  outlined_.write(edges_.run(source), objects_.view());
  return regions_.label(objects_.view());
}

const LocaliseOperation& localise_operation() {
  static const auto& operation = kept<LocaliseOperation>(
      {EdgeOperator::sobel, "localise_objects",
       "grey image to Sobel's edges, contours, filled interiors and centres of objects and holes",
       [] {
         VariantList<LocaliseState> list;
         list.add_with_threads("bitpacked_runs", Isa::baseline, &make_bitpacked, {0});
         for (const Isa isa : all_isas()) {
           list.add_with_threads("simd_runs", isa, &make_simd, {1, kSimdRunsWidth});
         }
         return list.take();
       }()});
  return operation;
}

}  // namespace thinbench::detail
