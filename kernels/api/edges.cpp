#include "thinbench/edges.hpp"

#include "core/checks.hpp"
#include "edges/state.hpp"

namespace thinbench {

void detect_edges(EdgeOperator op, ConstImageView source, ImageView destination,
                  const EdgeThresholds& thresholds, const Execution& execution) {
  detail::check_views(source, destination, detail::InPlace::rejected);
  detail::make_best_state(detail::operation_of(op), source.width, source.height, {op, thresholds},
                          execution)
      ->run(source, destination);
}

}  // namespace thinbench
