#include "thinbench/localise.hpp"

#include <memory>

#include "core/checks.hpp"
#include "core/packing.hpp"
#include "localise/state.hpp"

namespace thinbench {

namespace {

std::unique_ptr<detail::LocaliseState> state_for(const ConstImageView& grey,
                                                 const EdgeThresholds& thresholds,
                                                 const Execution& execution) {
  return detail::make_best_state(detail::localise_operation(), grey.width, grey.height,
                                 {EdgeOperator::sobel, thresholds}, execution);
}

}  // namespace

Regions localise_objects(ConstImageView grey, const EdgeThresholds& thresholds,
                         const Execution& execution) {
  detail::check_views(grey, grey, detail::InPlace::allowed);
  Regions found;
  state_for(grey, thresholds, execution)->run(grey, found);
  return found;
}

Regions localise_objects(ConstImageView grey, ImageView objects, const EdgeThresholds& thresholds,
                         const Execution& execution) {
  detail::check_views(grey, objects, detail::InPlace::allowed);
  const auto state = state_for(grey, thresholds, execution);
  Regions found;
  state->run(grey, found);
  const Isa isa = execution.isa.value_or(best_isa());
  detail::plane_conversion<std::uint64_t>(isa).write(state->objects(), objects);
  return found;
}

}  // namespace thinbench
