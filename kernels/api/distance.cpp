#include "thinbench/distance.hpp"

#include "core/checks.hpp"
#include "distance/state.hpp"

namespace thinbench {

void squared_distances(ConstImageView source, LabelView distances, const Execution& execution) {
  detail::check_views(source, distances);
  detail::make_best_state(detail::distance_operation(), source.width, source.height, {}, execution)
      ->run(source, distances);
}

}  // namespace thinbench
