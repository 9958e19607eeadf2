// Graphs of any image: equal to the reference, every pixel once, as many nodes more than edges as
// the Euler number says. Pruning keeps holes and components, and leaves no short branch. Polylines
// stay near their lines. Graphs made from graphs keep what they promise; those of labels equal a loop.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "drawn_image.hpp"
#include "graph.hpp"
#include "holes.hpp"
#include "reference.hpp"
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

void check_pixels(const Graph& graph, const ConstImageView& image) {
  ByteImage classes(image.width, image.height);
  classify_pixels(image, classes.view(), {});
  ByteImage drawn(image.width, image.height);
  const auto take = [&](Pixel p, bool may_be_line) {
    must(std::exchange(drawn.at(p.x, p.y), std::uint8_t{255}) == 0, "a pixel twice");
    const bool is_line = static_cast<PixelClass>(classes.at(p.x, p.y)) == PixelClass::line;
    must(may_be_line || !is_line, "a line pixel in a node");
  };
  for (const GraphNode& node : graph.nodes) {
    const bool is_of_line = node.kind == NodeKind::cycle || node.kind == NodeKind::given;
    for (const Pixel p : graph.pixels_of(node)) take(p, is_of_line);
  }
  for (const Pixel p : graph.edge_pixels) take(p, true);
  for (Index y = 0; y < image.height; ++y) {
    for (Index x = 0; x < image.width; ++x) {
      must((image.row(y)[x] != 0) == (drawn.at(x, y) != 0), "not the pixels of the image");
    }
  }
}

double distance(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along = square == 0 ? 0 : ((p.x - a.x) * dx + (p.y - a.y) * dy) / square;
  const double at = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - at * dx, p.y - a.y - at * dy);
}

/// Equal to the plain method; each point is near a line between two that are kept.
void check_polyline(const std::vector<Pixel>& points, double tolerance) {
  const std::vector<Pixel> kept = polyline(points, tolerance);
  must(kept == reference::polyline(points, tolerance), "not the polyline of the plain method");
  must(kept.front() == points.front() && kept.back() == points.back(), "other ends");
  for (const Pixel p : points) {
    bool is_near = false;
    for (std::size_t i = 1; i < kept.size() && !is_near; ++i) {
      is_near = distance(p, kept[i - 1], kept[i]) <= tolerance + 1e-9;
    }
    must(is_near, "a point far from the polyline");
  }
}

/// Infinite without background.
double width_at(const View<const double>& distances, Pixel p) {
  return 2 * distances.row(p.y)[p.x];
}

void check_edges(ByteSource& input, const Graph& graph, const View<const double>& distances) {
  constexpr std::array<double, 5> tolerances = {0, 0.5, 1, 2.5, 100};
  const double tolerance = input.pick(tolerances);
  const std::vector<EdgeWidths> widths = edge_widths(graph, distances);
  must(widths.size() == graph.edges.size(), "widths of other edges");
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const std::vector<Pixel> points = points_of(graph, graph.edges[i]);
    check_polyline(points, tolerance);
    for (const Pixel p : points) {
      const double width = width_at(distances, p);
      must(widths[i].least <= width && width <= widths[i].greatest, "a width beyond the others");
    }
    must(widths[i].least <= widths[i].mean + 1e-6 && widths[i].mean <= widths[i].greatest + 1e-6,
         "a mean beyond the widths");
    must(widths[i].least <= widths[i].median && widths[i].median <= widths[i].greatest,
         "a median beyond the widths");
  }
}

double limit_at(const Pruning& pruning, Pixel junction) {
  if (pruning.min_widths == 0) return pruning.min_length;
  return std::max(pruning.min_length, pruning.min_widths * width_at(pruning.distances, junction));
}

void must_have_no_short_branch(const Graph& graph, const Pruning& pruning) {
  for (const GraphEdge& edge : graph.edges) {
    const bool starts = graph.nodes[edge.from].kind == NodeKind::end;
    const bool stops = graph.nodes[edge.to].kind == NodeKind::end;
    if (starts == stops) continue;
    must(length_of(edge, pruning.spacing) >= limit_at(pruning, starts ? edge.stop : edge.start),
         "a short branch");
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
  DrawnImage source(input, {image.width(), image.height()});
  DrawnImage destination(input, {image.width(), image.height()});
  source.copy_from(image.view());
  const ImageView to = input.once_in(4) ? source.view() : destination.view();
  const Graph graph = prune(source.view(), to, pruning, execution);
  source.must_be_intact();
  destination.must_be_intact();
  must(graph == reference::skeleton_graph(to), "not the graph of the pruned image");
  ByteImage expected(image.width(), image.height());
  reference::prune(image.view(), expected.view(), pruning);
  must(equal(expected.view(), to), "not the pruned image of the plain method");
  must_have_no_short_branch(graph, pruning);
  for (Index y = 0; y < to.height; ++y) {
    for (Index x = 0; x < to.width; ++x) {
      must(to.row(y)[x] == 0 || (to.row(y)[x] == 255 && image.at(x, y) != 0), "a new pixel");
    }
  }
  const reference::Regions before = reference::holes(image.view());
  const reference::Regions after = reference::holes(to);
  must(before.holes.size() == after.holes.size(), "another number of holes");
  must(pruning.removes_components ? after.objects.size() <= before.objects.size()
                                  : after.objects.size() == before.objects.size(),
       "another number of components");
}

void check_graph(ByteSource& input) {
  const DrawnSize size = draw_size(input);
  const Execution execution = draw_execution(input);
  const ByteImage image = draw_binary(input, size);
  const Graph graph = skeleton_graph(image.view(), execution);
  must(graph == reference::skeleton_graph(image.view()), "another graph");
  must(std::ssize(graph.nodes) - std::ssize(graph.edges) == reference::euler_number(image.view()),
       "another Euler number");
  check_pixels(graph, image.view());
  constexpr std::array<Spacing, 4> spacings = {{{1, 1}, {1, 1}, {0.3, 0.3}, {2, 0.25}}};
  const Spacing spacing = input.pick(spacings);
  std::vector<double> numbers(static_cast<std::size_t>(size.width * size.height) + 1);
  const View<double> of_image = {numbers.data(), size.width, size.height};
  distances(image.view(), of_image, spacing, execution);
  check_edges(input, graph, of_image);
  check_pruning(input, image, of_image, spacing, execution);
}

/// Graphs made from a graph.
void check_parts(ByteSource& input) {
  const ByteImage image = draw_binary(input, draw_size(input));
  const Graph graph = skeleton_graph(image.view());
  if (graph.edge_pixels.empty()) return;
  const auto last = static_cast<Index>(graph.edge_pixels.size()) - 1;
  const Pixel pixel = graph.edge_pixels[static_cast<std::size_t>(input.number(0, last))];
  const Graph split = split_at(graph, {&pixel, 1});
  must(split.nodes.size() == graph.nodes.size() + 1, "no new node");
  must(split.edges.size() == graph.edges.size() + 1, "no new edge");
  check_pixels(split, image.view());
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
  const std::vector<Branch> rows = summary(part);
  must(part.edges.size() == chosen.size() && rows.size() == chosen.size(), "other edges");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    must(points_of(part, part.edges[i]) == points_of(graph, graph.edges[chosen[i]]), "other points");
    must(rows[i].length >= rows[i].chord - 1e-9, "a chord longer than its line");
  }
}

/// Equal to a loop over the labels.
void check_labels(ByteSource& input) {
  const auto [width, height] = draw_size(input);
  std::vector<std::int32_t> labels(static_cast<std::size_t>(width * height));
  for (std::int32_t& label : labels) label = input.byte() % 5 - 1;
  const LabelGraph found = graph_of_labels({labels.data(), width, height});
  std::size_t nodes = 0;
  std::size_t edges = 0;
  for (const std::int32_t label : {-1, 1, 2, 3}) {
    ByteImage mask(width, height);
    for (Index i = 0; i < width * height; ++i) {
      if (labels[static_cast<std::size_t>(i)] == label) mask.at(i % width, i / width) = 255;
    }
    const Graph graph = reference::skeleton_graph(mask.view());
    for (const GraphNode& node : graph.nodes) {
      must(nodes < found.labels.size() && found.labels[nodes] == label, "another label");
      must(std::ranges::equal(found.graph.pixels_of(found.graph.nodes[nodes++]),
                              graph.pixels_of(node)),
           "another node");
    }
    for (const GraphEdge& edge : graph.edges) {
      must(edges < found.graph.edges.size() &&
               points_of(found.graph, found.graph.edges[edges++]) == points_of(graph, edge),
           "another edge");
    }
  }
  must(nodes == found.graph.nodes.size() && edges == found.graph.edges.size(), "more graphs");
}

void check(ByteSource& input) {
  if (input.once_in(4)) return check_labels(input);
  if (input.once_in(4)) return check_parts(input);
  check_graph(input);
}

}  // namespace
}  // namespace thinbench

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  thinbench::ByteSource input(data, size);
  try {
    thinbench::check(input);
  } catch (const std::invalid_argument& error) {
    thinbench::must_be_one_line(error.what());
  }
  return 0;
}
