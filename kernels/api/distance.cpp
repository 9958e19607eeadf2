#include "thinbench/distance.hpp"

#include "api/catalogue.hpp"
#include "image/checks.hpp"

namespace thinbench {

void squared_distances(ConstImageView source, LabelView distances, const Options& options) {
  detail::check_views(source, distances);
  const detail::DistanceOperation& operation = detail::distance_operation();
  const auto& variant = detail::choose(operation, source.width, source.height, options);
  detail::make_state(operation, variant, source.width, source.height, options)
      ->run(source, distances);
}

}  // namespace thinbench
