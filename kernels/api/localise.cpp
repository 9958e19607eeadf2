#include "thinbench/localise.hpp"

#include "core/checks.hpp"
#include "localise/state.hpp"

namespace thinbench {

Regions localise_objects(ConstImageView grey, const EdgeThresholds& thresholds,
                         const Execution& execution, ImageView objects) {
  const bool writes_objects = objects.width != 0 || objects.height != 0;
  if (writes_objects) {
    detail::check(detail::memory_of("grey", grey), detail::memory_of("objects", objects),
                  detail::InPlace::allowed);
  } else {
    detail::check(detail::memory_of("grey", grey));
  }
  const auto state = detail::make_best_state(detail::localise_operation(), grey.width, grey.height,
                                             {EdgeOperator::sobel, thresholds}, execution);
  Regions found;
  state->run(grey, found);
  if (writes_objects) state->write_objects(objects);
  return found;
}

}  // namespace thinbench
