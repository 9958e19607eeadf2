#include "thinbench/localise.hpp"

#include "api/catalogue.hpp"
#include "image/checks.hpp"

namespace thinbench {

Regions localise_objects(ConstImageView grey, const EdgeThresholds& thresholds,
                         const Options& options) {
  detail::check_views(grey, grey, detail::InPlace::allowed);
  const detail::LocaliseOperation& operation = detail::localise_operation();
  const auto& variant = detail::choose(operation, grey.width, grey.height, options);
  const auto state =
      detail::make_state(operation, variant, grey.width, grey.height, thresholds, options);
  const detail::RegionLists lists = state->run(grey);
  return {{lists.objects.begin(), lists.objects.end()}, {lists.holes.begin(), lists.holes.end()}};
}

}  // namespace thinbench
