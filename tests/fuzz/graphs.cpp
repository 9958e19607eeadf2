// Graphs, pruning, main paths and polylines of any image equal those of plain methods, and the
// graphs of labels a loop. Widths are those along the lines. Graphs made from graphs keep what they
// promise.
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "drawn_image.hpp"
#include "graph.hpp"
#include "graph/label_loop.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/graph_parts.hpp"
#include "thinbench/graph_paths.hpp"

namespace thinbench {
namespace {

Execution draw_execution(ByteSource& input) {
  Execution execution;
  if (input.once_in(2)) execution.isa = static_cast<Isa>(input.number(0, 4));
  if (input.once_in(16)) execution.threads = 2;
  return execution;
}

void check_edges(ByteSource& input, const Graph& graph, const View<const double>& distances) {
  constexpr std::array<double, 5> tolerances = {0, 0.5, 1, 2.5, 100};
  const double tolerance = input.pick(tolerances);
  const std::vector<EdgeWidths> widths = edge_widths(graph, distances);
  must(widths.size() == graph.edges.size(), "widths of other edges");
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::vector<Pixel> points = points_of(graph, graph.edges[i]);
    must(polyline(points, tolerance) == reference::polyline(points, tolerance),
         "not the polyline of the plain method");
    for (const Pixel p : points) {
      const double width = 2 * distances.row(p.y)[p.x];
      must(widths[i].min <= width && width <= widths[i].max, "a width beyond the others");
    }
    must(widths[i].min <= widths[i].mean + 1e-6 && widths[i].mean <= widths[i].max + 1e-6,
         "a mean beyond the widths");
    must(widths[i].min <= widths[i].median && widths[i].median <= widths[i].max,
         "a median beyond the widths");
  }
}

void check_pruning(ByteSource& input, const ByteImage& image, const View<const double>& distances,
                   const Spacing& spacing, const Execution& execution) {
  constexpr std::array<double, 6> lengths = {0, 1, 2, 4.5, 10, 1000};
  constexpr std::array<double, 4> widths = {0, 0, 0.6, 3};
  Pruning pruning = {.min_length = input.pick(lengths), .min_widths = input.pick(widths)};
  pruning.distances = distances;
  pruning.spacing = spacing;
  pruning.removes_components = input.once_in(4);
  DrawnPair images(input, image.view());
  const ImageView to = images.to();
  const Graph graph = prune(images.source.view(), to, pruning, execution);
  images.must_be_intact();
  must(graph == reference::skeleton_graph(to), "not the graph of the pruned image");
  ByteImage expected(image.width(), image.height());
  reference::prune(image.view(), expected.view(), pruning);
  must(equal(expected.view(), to), "not the pruned image of the plain method");
}

void check_main_paths(const ConstImageView& image, const Graph& graph, const Spacing& spacing) {
  if (graph.node_pixels.size() + graph.edge_pixels.size() > 100) return;  // all pairs of pixels
  const std::vector<GraphPath> paths = main_paths(graph, spacing);
  const std::vector<reference::MainPath> expected = reference::main_paths(image, spacing);
  must(paths.size() == expected.size(), "another number of main paths");
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const double difference = std::abs(paths[i].length - expected[i].length);
    must(difference <= 1e-12 * expected[i].length, "another main path");
    must(!points_of(graph, paths[i], spacing).empty(), "a path without pixels");
  }
}

void check_graph(ByteSource& input) {
  const DrawnSize size = draw_size(input);
  const Execution execution = draw_execution(input);
  const ByteImage image = draw_binary(input, size);
  const Graph graph = skeleton_graph(image.view(), execution);
  must(graph == reference::skeleton_graph(image.view()), "another graph");
  constexpr std::array<Spacing, 4> spacings = {{{1, 1}, {1, 1}, {0.3, 0.3}, {2, 0.25}}};
  const Spacing spacing = input.pick(spacings);
  std::vector<double> numbers(static_cast<std::size_t>(size.width * size.height) + 1);
  const View<double> of_image = {numbers.data(), size.width, size.height};
  distances(image.view(), of_image, spacing, execution);
  check_edges(input, graph, of_image);
  check_main_paths(image.view(), graph, spacing);
  check_pruning(input, image, of_image, spacing, execution);
}

/// Graphs made from a graph.
void check_parts(ByteSource& input) {
  const ByteImage image = draw_binary(input, draw_size(input));
  const Graph graph = skeleton_graph(image.view());
  if (graph.edge_pixels.empty()) return;
  const auto last = static_cast<Index>(graph.edge_pixels.size()) - 1;
  const Pixel pixel = graph.edge_pixels[static_cast<std::size_t>(input.number(0, last))];
  const Graph split = split_graph(graph, {&pixel, 1});
  must(split.nodes.size() == graph.nodes.size() + 1, "no new node");
  must(split.edges.size() == graph.edges.size() + 1, "no new edge");
  must(split.node_pixels.size() + split.edge_pixels.size() ==
           graph.node_pixels.size() + graph.edge_pixels.size(),
       "other pixels");
  const GraphPlace place = nearest_place(split, pixel.x, pixel.y);
  must(place.pixel == pixel && place.distance == 0, "another nearest pixel");
  const Graph open = open_cycles(graph);
  const auto nodes = static_cast<std::uint32_t>(graph.nodes.size());
  must(cycles(nodes, links_of(open)).empty(), "a cycle remains");
  must(components_of(nodes, links_of(open)) == components_of(nodes, links_of(graph)),
       "another component");
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < graph.edges.size(); i += 2) chosen.push_back(i);
  const Graph part = subgraph(graph, chosen);
  const std::vector<EdgeSummary> rows = summary(part);
  must(part.edges.size() == chosen.size() && rows.size() == chosen.size(), "other edges");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    must(points_of(part, part.edges[i]) == points_of(graph, graph.edges[chosen[i]]),
         "other points");
    must(rows[i].length >= rows[i].chord - 1e-9, "a chord longer than its line");
  }
}

/// Equal to a loop over the labels.
void check_labels(ByteSource& input) {
  const auto [width, height] = draw_size(input);
  LabelImage image = {width, height, {}};
  for (Index i = 0; i < width * height; ++i) image.labels.push_back(input.byte() % 5 - 1);
  must(graph_of_labels(image.view()) == graph_of_each_label(image), "another graph of labels");
}

}  // namespace

void try_input(ByteSource& input) {
  must_succeed_or_explain<std::invalid_argument>([&] {
    if (input.once_in(4)) return check_labels(input);
    if (input.once_in(4)) return check_parts(input);
    check_graph(input);
  });
}

}  // namespace thinbench
