// Graphs of skeletons, and pruning.
#include <utility>

#include "core/checks.hpp"
#include "graph/state.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

void check(const Pruning& pruning, const ConstImageView& skeleton) {
  detail::require_not_negative("min_length", pruning.min_length);
  detail::require_not_negative("min_widths", pruning.min_widths);
  detail::require_spacing(pruning.spacing);
  if (pruning.min_widths == 0) return;
  const View<const double>& distances = pruning.distances;
  detail::require(distances.data != nullptr && distances.width == skeleton.width &&
                      distances.height == skeleton.height,
                  "min_widths: expected distances of size " +
                      detail::size_text(skeleton.width, skeleton.height));
  detail::check(detail::memory_of("distances", distances));
}

}  // namespace

Graph skeleton_graph(ConstImageView skeleton, const Execution& execution) {
  detail::check(detail::memory_of("skeleton", skeleton));
  const auto state = detail::make_best_state(detail::graph_operation(), skeleton.width,
                                             skeleton.height, {}, execution);
  return std::move(state->run(skeleton));
}

Graph prune(ConstImageView skeleton, ImageView destination, const Pruning& pruning,
            const Execution& execution) {
  detail::check(detail::memory_of("skeleton", skeleton),
                detail::memory_of("destination", destination), detail::InPlace::allowed);
  check(pruning, skeleton);
  const auto state = detail::make_best_state(detail::graph_operation(), skeleton.width,
                                             skeleton.height, {}, execution);
  if (skeleton.width == 0 || skeleton.height == 0) return {};  // such rows need no memory
  return state->prune(skeleton, pruning, destination);
}

}  // namespace thinbench
