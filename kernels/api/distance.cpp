#include "thinbench/distance.hpp"

#include "core/checks.hpp"
#include "distance/state.hpp"

namespace thinbench {
namespace {

template <class T, class... Form>
void run(const ConstImageView& source, const View<T>& distances, const Execution& execution,
         const Form&... form) {
  using enum detail::InPlace;
  detail::check(detail::memory_of("source", source), detail::memory_of("distances", distances),
                rejected);
  detail::make_best_state(detail::distance_operation(), source.width, source.height, {}, execution)
      ->run(source, distances, form...);
}

}  // namespace

void squared_distances(ConstImageView source, LabelView distances, const Execution& execution) {
  run(source, distances, execution);
}

void distances(ConstImageView source, View<double> distances, const Spacing& spacing,
               const Execution& execution) {
  detail::require_spacing(spacing);
  run(source, distances, execution, spacing);
}

}  // namespace thinbench
