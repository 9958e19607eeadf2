#include <utility>
#include <vector>

#include "graph.hpp"
#include "harness/families.hpp"
#include "techniques/variants.hpp"

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

class GraphJob : public Job {
 public:
  [[nodiscard]] bool gives_image() const override { return false; }
  [[nodiscard]] std::string name_of_number(std::size_t index) const override {
    if (index < 2) return index == 0 ? "nodes" : "edges";
    return "number " + std::to_string(index) + " of nodes, edges and their pixels";
  }
};

class StateJob final : public GraphJob {
 public:
  explicit StateJob(std::unique_ptr<detail::GraphState> state) : state_(std::move(state)) {}

  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    graph_ = &state_->run(input);
  }

  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return numbers_of(*graph_); }

 private:
  std::unique_ptr<detail::GraphState> state_;
  const Graph* graph_ = nullptr;
};

class ReferenceJob final : public GraphJob {
 public:
  void run(const ConstImageView& input, const ImageView& /*output*/) override {
    graph_ = reference::skeleton_graph(input);
  }
  [[nodiscard]] std::vector<std::int64_t> numbers() const override { return numbers_of(graph_); }

 private:
  Graph graph_;
};

}  // namespace

std::vector<Operation> graph_family() {
  const detail::GraphOperation& operation = detail::study::graph_operation();
  Operation result = {
      std::string(operation.name), operation.description, InputKind::binary, {}, {}};
  for (const detail::Variant<detail::GraphState>& variant : operation.variants) {
    result.variants.push_back(
        library_variant(variant, false, [&variant](Index width, Index height, int threads) {
          return std::make_unique<StateJob>(
              detail::make_state(variant, width, height, {}, threads));
        }));
  }
  result.reference = [](Index, Index, int) { return std::make_unique<ReferenceJob>(); };
  result.operation = operation.name;
  result.measured_on_skeletons = true;
  return {result};
}

}  // namespace thinbench
