#include "localise/state.hpp"

#include "core/exported.hpp"

namespace thinbench::detail {
namespace {

std::unique_ptr<LocaliseState> make_state(const LocaliseSetting& setting) {
  return std::make_unique<LocaliseState>(setting);
}

}  // namespace

LocaliseState::LocaliseState(const LocaliseSetting& setting)
    : team_(setting.threads),
      conversion_(plane_conversion<std::uint64_t>(setting.isa)),
      edges_(setting),
      outlined_(setting.isa, setting.width, setting.height),
      objects_(setting.width, setting.height),
      regions_(kernels_of<RunEngine>(setting.isa), true, setting.isa, setting.width, setting.height,
               team_) {}

void LocaliseState::run(const ConstImageView& source, Regions& found) {
  outlined_.write(edges_.run(source), objects_.view());
  regions_.find(objects_.view(), found);
}

const LocaliseOperation& localise_operation() {
  static const auto& operation = never_destroyed<LocaliseOperation>(
      {EdgeOperator::sobel, "localise_objects",
       "grey image to Sobel's edges, contours, filled interiors and centres of objects and holes",
       [] {
         VariantList<LocaliseState> list;
         for (const Isa isa : isas_of<RunEngine, EdgeKernels>()) {
           list.add_with_threads("simd_runs", isa, &make_state, {});
         }
         return list.take();
       }()});
  return operation;
}

}  // namespace thinbench::detail
