#include "thinbench/midpoint_scan.hpp"

#include "core/checks.hpp"
#include "midpoints/state.hpp"

namespace thinbench {

void midpoint_scan(ConstImageView source, ImageView destination, Directions directions,
                   Border border, const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::allowed);
  detail::make_best_state(detail::midpoint_operation(), source.width, source.height,
                          {directions, border}, execution)
      ->run(source, destination);
}

}  // namespace thinbench
