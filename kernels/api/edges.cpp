#include "thinbench/edges.hpp"

#include "api/catalogue.hpp"
#include "image/checks.hpp"

namespace thinbench {

void detect_edges(EdgeOperator op, ConstImageView source, ImageView destination,
                  const EdgeThresholds& thresholds, const Options& options) {
  detail::check_views(source, destination, detail::InPlace::rejected);
  const detail::EdgeOperation& operation = detail::operation_of(op);
  const auto& variant = detail::choose(operation, source.width, source.height, options);
  detail::make_state(operation, variant, source.width, source.height, thresholds, options)
      ->run(source, destination);
}

}  // namespace thinbench
