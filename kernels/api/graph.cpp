#include "thinbench/graph.hpp"

#include "core/checks.hpp"
#include "graph/state.hpp"

namespace thinbench {

Graph skeleton_graph(ConstImageView skeleton, const Execution& execution) {
  detail::check_views(skeleton, skeleton, detail::InPlace::allowed);
  const auto state = detail::make_best_state(detail::graph_operation(), skeleton.width,
                                             skeleton.height, {}, execution);
  state->load(skeleton);
  return state->compute();
}

}  // namespace thinbench
