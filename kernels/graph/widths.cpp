#include "graph/widths.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "core/checks.hpp"
#include "core/variant.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {
namespace {

double median_of(std::vector<double>& numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  if (numbers.size() % 2 == 1) return *middle;
  return (*std::max_element(numbers.begin(), middle) + *middle) / 2;
}

EdgeWidths summary_of(std::vector<double>& widths) {
  const auto [min, max] = std::minmax_element(widths.begin(), widths.end());
  EdgeWidths found = {0, 0, *min, *max};
  const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
  found.mean = std::clamp(sum / static_cast<double>(widths.size()), found.min, found.max);
  found.median = median_of(widths);
  return found;
}

}  // namespace

void detail::check_distances(const View<const double>& distances) {
  const auto [data, width, height, stride] = distances;
  require(data != nullptr || width == 0 || height == 0, "distances has no data");
  require(stride >= width, "distances has a stride of " + std::to_string(stride) +
                               ", below its width of " + std::to_string(width));
}

std::vector<EdgeWidths> edge_widths(const Graph& graph, View<const double> distances,
                                    const Execution& execution) {
  detail::require_execution(execution);
  detail::check_distances(distances);
  std::vector<EdgeWidths> found;
  std::vector<double> widths;
  for (const GraphEdge& edge : graph.edges) {
    widths.clear();
    for (const Pixel p : points_of(graph, edge)) {
      const bool is_inside =
          p.x >= 0 && p.y >= 0 && p.x < distances.width && p.y < distances.height;
      detail::require(is_inside, "distances: smaller than the image of the graph");
      widths.push_back(2 * distances.row(p.y)[p.x]);
    }
    found.push_back(summary_of(widths));
  }
  return found;
}

}  // namespace thinbench
