#include "cli/graph_request.hpp"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/thinning_request.hpp"
#include "support/file_error.hpp"
#include "support/text.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/graph_labels.hpp"
#include "thinbench/graph_parts.hpp"
#include "thinbench/labels.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

RequestedThinning thinning_of(const GraphRequest& request) {
  ThinningRequest thinning;
  thinning.rule = request.thinning;
  return requested_thinning(thinning);
}

/// The nodes to make lie on the pruned skeleton.
template <class T>
void check_nodes(const View<T>& skeleton, const ImagePage& page, const GraphRequest& request) {
  for (const auto [x, y] : request.nodes) {
    if (x < skeleton.width && y < skeleton.height && skeleton.row(y)[x] != 0) continue;
    throw FileError(fmt::format("{}: --node {},{} is not on the skeleton", page.file, x, y));
  }
}

/// What the request wants to know of a pruned graph.
FoundGraph described(Graph graph, const View<double>& distances, const ImagePage& page,
                     const GraphRequest& request) {
  const Spacing& spacing = request.pruning.spacing;
  const double tolerance = request.tolerance.value_or(std::max(spacing.x, spacing.y));
  if (!request.nodes.empty()) graph = split_graph(graph, request.nodes);
  if (request.open_cycles) graph = open_cycles(graph, *request.open_cycles, spacing);
  FoundGraph found = {
      page, distances.width, distances.height, {}, {}, {}, spacing, request.unit, {}, {}, {}};
  found.widths = edge_widths(graph, distances);
  for (const GraphEdge& edge : graph.edges) {
    found.lines.push_back(polyline(points_of(graph, edge), tolerance, spacing));
  }
  if (request.with_main_paths) {
    found.main_paths = main_paths(graph, spacing);
    for (const GraphPath& path : found.main_paths) {
      found.main_lines.push_back(polyline(points_of(graph, path, spacing), tolerance, spacing));
    }
  }
  found.graph = std::move(graph);
  return found;
}

}  // namespace

void add_graph_options(CLI::App& app, GraphRequest& request) {
  constexpr double no_limit = 1e9;
  add_value(app, "--thinning", request.thinning,
            "Operation that thins the image; none: it is a skeleton", not_empty(), "NAME")
      ->capture_default_str();
  add_spacing_option(app, request.pruning.spacing);
  add_value(app, "--unit", request.unit, "Name of the unit of the spacing, for files", printable(),
            "NAME");
  CLI::Option* const prune =
      add_value(app, "--prune", request.pruning.min_length, "Remove branches shorter than LENGTH",
                real_number(0, no_limit), "LENGTH");
  add_value(app, "--prune-widths", request.pruning.min_widths,
            "Remove branches shorter than N times the object's width at their junction",
            real_number(0, no_limit), "N");
  app.add_flag("--remove-components", request.pruning.removes_components,
               "Also remove lines and pixels on their own below LENGTH")
      ->needs(prune);
  add_value(app, "--open-cycles", request.open_cycles,
            "Remove the longest line of each cycle of at most LENGTH", real_number(0, no_limit),
            "LENGTH");
  app.add_flag("--main-path", request.with_main_paths,
               "Also the longest of the shortest paths between pixels of each component");
  add_value(app, "--tolerance", request.tolerance,
            "How far a line may be from the points that are listed for it, in the unit of the "
            "spacing (default: the larger side of a pixel)",
            real_number(0, no_limit), "N");
}

std::string checked_thinning(const GraphRequest& request) {
  if (request.is_skeleton()) return {};
  const RequestedThinning thinning = thinning_of(request);
  check_options(thinning);
  return thinning.contents;
}

ByteImage skeleton_of(const ByteImage& image, const GraphRequest& request) {
  ByteImage skeleton = copy_of(image.view());
  if (!request.is_skeleton()) {
    thin(thinning_of(request).rule, image.view(), skeleton.view(), {},
         {.threads = request.threads});
  }
  return skeleton;
}

std::string thickness_of(const ByteImage& skeleton) {
  const FullBlocks blocks = full_blocks(skeleton.view());
  if (blocks.count == 0) return {};
  return fmt::format("{} of 2 x 2 pixels, the first at ({}, {})", counted(blocks.count, "block"),
                     blocks.first.x, blocks.first.y);
}

FoundGraph find_graph(const ByteImage& image, ByteImage& skeleton, const ImagePage& page,
                      const GraphRequest& request) {
  const Index width = image.width(), height = image.height();
  const Execution execution = {.threads = request.threads};
  Pruning pruning = request.pruning;
  std::vector<double> numbers(static_cast<std::size_t>(width * height));
  const View<double> of_image(numbers.data(), width, height);
  distances(image.view(), of_image, pruning.spacing, execution);
  pruning.distances = of_image;
  Graph pruned = prune(skeleton.view(), skeleton.view(), pruning, execution);
  check_nodes(skeleton.view(), page, request);
  return described(std::move(pruned), of_image, page, request);
}

LabelPixels skeletons_of(const LabelPixels& objects, const GraphRequest& request) {
  LabelPixels skeletons = objects;
  if (!request.is_skeleton()) {
    thin_labels(thinning_of(request).rule, objects.view(), skeletons.view(), {},
                {.threads = request.threads});
  }
  return skeletons;
}

FoundGraph find_graphs(const LabelPixels& objects, LabelPixels& skeletons, const ImagePage& page,
                       const GraphRequest& request) {
  const Execution execution = {.threads = request.threads};
  Pruning pruning = request.pruning;
  std::vector<double> numbers(objects.labels.size());
  const View<double> of_objects(numbers.data(), objects.width, objects.height);
  distances_of_labels(objects.view(), of_objects, pruning.spacing, execution);
  pruning.distances = of_objects;
  LabelGraph pruned = prune_labels(skeletons.view(), skeletons.view(), pruning, execution);
  check_nodes(skeletons.view(), page, request);
  FoundGraph found = described(std::move(pruned.graph), of_objects, page, request);
  for (const GraphNode& node : found.graph.nodes) {
    const Pixel first = found.graph.pixels_of(node).front();
    found.labels.push_back(skeletons.view().row(first.y)[first.x]);
  }
  return found;
}

}  // namespace thinbench
