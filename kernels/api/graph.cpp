#include "thinbench/graph.hpp"

#include "api/catalogue.hpp"
#include "image/checks.hpp"

namespace thinbench {

Graph skeleton_graph(ConstImageView skeleton, const Options& options) {
  detail::check_views(skeleton, skeleton, detail::InPlace::allowed);
  const detail::GraphOperation& operation = detail::graph_operation();
  const auto& variant = detail::choose(operation, skeleton.width, skeleton.height, options);
  if (skeleton.width == 0 || skeleton.height == 0) return {};  // such rows need no memory
  const auto state =
      detail::make_state(operation, variant, skeleton.width, skeleton.height, options);
  state->load(skeleton);
  return state->compute();
}

}  // namespace thinbench
