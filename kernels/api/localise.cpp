#include "thinbench/localise.hpp"

#include "core/checks.hpp"
#include "localise/state.hpp"

namespace thinbench {

Regions localise_objects(ConstImageView grey, const EdgeThresholds& thresholds,
                         const Execution& execution) {
  detail::check_views(grey, grey, detail::InPlace::allowed);
  const auto state = detail::make_best_state(detail::localise_operation(), grey.width, grey.height,
                                             {EdgeOperator::sobel, thresholds}, execution);
  const detail::RegionLists lists = state->run(grey);
  return {{lists.objects.begin(), lists.objects.end()}, {lists.holes.begin(), lists.holes.end()}};
}

}  // namespace thinbench
