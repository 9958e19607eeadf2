#include "graph.hpp"
#include "harness/library_operation.hpp"

namespace thinbench {
namespace {

/// Both counts, then every member of nodes and edges with their pixels.
std::vector<std::int64_t> numbers_of(const Graph& graph) {
  std::vector<std::int64_t> numbers = {static_cast<std::int64_t>(graph.nodes.size()),
                                       static_cast<std::int64_t>(graph.edges.size())};
  const auto append_pixels = [&](std::span<const Pixel> pixels) {
    for (const Pixel p : pixels) numbers.insert(numbers.end(), {p.x, p.y});
  };
  for (const GraphNode& node : graph.nodes) {
    numbers.insert(numbers.end(), {static_cast<std::int64_t>(node.kind), node.pixel_count});
    append_pixels(graph.pixels_of(node));
  }
  for (const GraphEdge& edge : graph.edges) {
    numbers.insert(numbers.end(), {edge.from, edge.to, edge.start.x, edge.start.y, edge.stop.x,
                                   edge.stop.y, edge.steps.horizontal + edge.steps.vertical,
                                   edge.steps.diagonal, edge.pixel_count});
    append_pixels(graph.pixels_of(edge));
  }
  return numbers;
}

/// A graph that belongs to a state, or to this.
struct FoundGraph {
  static constexpr bool kGivesImage = false;
  const Graph* graph = nullptr;
  Graph own = {};
  [[nodiscard]] std::vector<std::int64_t> numbers() const { return numbers_of(*graph); }
  [[nodiscard]] static std::string name_of_number(std::size_t index) {
    if (index < 2) return index == 0 ? "nodes" : "edges";
    return "number " + std::to_string(index) + " of nodes, edges and their pixels";
  }
};

}  // namespace

std::vector<Operation> graph_family() {
  Operation result = library_operation<FoundGraph>(
      detail::study::graph_operation(), {}, InputKind::binary,
      [](detail::GraphState& state, const auto& input, const auto&, auto& found) {
        found.graph = &state.run(input);
      },
      job_maker<FoundGraph>([](const auto& input, const auto&, auto& found) {
        found.own = reference::skeleton_graph(input);
        found.graph = &found.own;
      }));
  result.measured_on_skeletons = true;
  return {result};
}

}  // namespace thinbench
