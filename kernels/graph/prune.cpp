#include <algorithm>
#include <cmath>
#include <string>

#include "core/checks.hpp"
#include "graph/pruner.hpp"
#include "graph/state.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

using detail::require;

void check_distances(const ConstLabelView& squared_distances) {
  const auto [data, width, height, stride] = squared_distances;
  require(data != nullptr || width == 0 || height == 0, "squared_distances has no data");
  require(stride >= width, "squared_distances has a stride of " + std::to_string(stride) +
                               ", below its width of " + std::to_string(width));
}

void check(const Pruning& pruning, const ConstImageView& skeleton) {
  const auto check_limit = [](const char* name, double value) {
    require(value >= 0 && std::isfinite(value),
            std::string(name) + ": expected a number of at least 0, got " + std::to_string(value));
  };
  check_limit("min_length", pruning.min_length);
  check_limit("min_widths", pruning.min_widths);
  const ConstLabelView& distances = pruning.squared_distances;
  require(
      pruning.min_widths == 0 || (distances.data != nullptr && distances.width == skeleton.width &&
                                  distances.height == skeleton.height),
      "min_widths: expected squared_distances of size " +
          detail::size_text(skeleton.width, skeleton.height));
  if (pruning.min_widths != 0) check_distances(distances);
}

}  // namespace

Graph prune(ConstImageView skeleton, ImageView destination, const Pruning& pruning,
            const Execution& execution) {
  detail::check_views(skeleton, destination, detail::InPlace::allowed);
  check(pruning, skeleton);
  const auto state = detail::make_best_state(detail::graph_operation(), skeleton.width,
                                             skeleton.height, {}, execution);
  if (skeleton.width == 0 || skeleton.height == 0) return {};  // such rows need no memory
  state->load(skeleton);
  return state->prune(pruning, destination);
}

std::vector<EdgeWidths> edge_widths(const Graph& graph, ConstLabelView squared_distances) {
  check_distances(squared_distances);
  const auto width_of = [&](Pixel p) {
    require(p.x < squared_distances.width && p.y < squared_distances.height,
            "squared_distances: smaller than the image of the graph");
    return detail::width_at(squared_distances, p);
  };
  std::vector<EdgeWidths> widths;
  for (const GraphEdge& edge : graph.edges) {
    const double first = width_of(edge.start);
    const double last = width_of(edge.stop);
    EdgeWidths found = {first + last, std::min(first, last), std::max(first, last)};
    for (const Pixel p : graph.pixels_of(edge)) {
      const double width = width_of(p);
      found.mean += width;
      found.least = std::min(found.least, width);
      found.greatest = std::max(found.greatest, width);
    }
    found.mean = std::clamp(found.mean / (edge.pixel_count + 2.0), found.least, found.greatest);
    widths.push_back(found);
  }
  return widths;
}

}  // namespace thinbench
