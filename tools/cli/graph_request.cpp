#include "cli/graph_request.hpp"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/thinning_request.hpp"
#include "support/file_error.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

RequestedThinning thinning_of(const GraphRequest& request) {
  ThinningRequest thinning;
  thinning.rule = request.thinning;
  return requested_thinning(thinning);
}

}  // namespace

void add_graph_options(CLI::App& app, GraphRequest& request) {
  constexpr double no_limit = 1e9;
  app.add_option("--thinning", request.thinning,
                 "Operation that thins the image; none: it is a skeleton")
      ->check(not_empty())
      ->type_name("NAME")
      ->capture_default_str();
  add_spacing_option(app, request.pruning.spacing);
  app.add_option("--unit", request.unit, "Name of the unit of the spacing, for files")
      ->check(not_empty())
      ->type_name("NAME");
  CLI::Option* const prune =
      app.add_option("--prune", request.pruning.min_length, "Remove branches shorter than LENGTH")
          ->check(real_number(0, no_limit))
          ->type_name("LENGTH");
  app.add_option("--prune-widths", request.pruning.min_widths,
                 "Remove branches shorter than N times the object's width at their junction")
      ->check(real_number(0, no_limit))
      ->type_name("N");
  app.add_flag("--remove-components", request.pruning.removes_components,
               "Also remove lines and pixels on their own below LENGTH")
      ->needs(prune);
  app.add_flag("--main-path", request.with_main_paths,
               "Also the longest of the shortest paths of each component");
  app.add_option("--tolerance", request.tolerance,
                 "How far a line may be from the points that are listed for it")
      ->check(real_number(0, no_limit))
      ->type_name("N")
      ->capture_default_str();
}

std::string graph_words(const GraphRequest& request) {
  const GraphRequest usual;
  std::string words;
  if (request.thinning != usual.thinning) words += " --thinning " + request.thinning;
  const Pruning& pruning = request.pruning;
  const Spacing& spacing = pruning.spacing;
  if (spacing != Spacing{}) words += fmt::format(" --spacing {},{}", spacing.y, spacing.x);
  if (!request.unit.empty()) words += " --unit " + request.unit;
  if (pruning.min_length > 0) words += fmt::format(" --prune {}", pruning.min_length);
  if (pruning.min_widths > 0) words += fmt::format(" --prune-widths {}", pruning.min_widths);
  if (pruning.removes_components) words += " --remove-components";
  if (request.with_main_paths) words += " --main-path";
  if (request.tolerance != usual.tolerance) {
    words += fmt::format(" --tolerance {}", request.tolerance);
  }
  return words;
}

void check_graph_size(const std::string& file, Index width, Index height) {
  if (std::max(width, height) <= kMaxDistanceSide) return;
  throw FileError(fmt::format("{}: expected sides of at most {} pixels, got {} x {}", file,
                              kMaxDistanceSide, width, height));
}

void check_thinning(const GraphRequest& request) {
  if (!request.is_skeleton()) static_cast<void>(thinning_of(request));
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
  return fmt::format("{} block{} of 2 x 2 pixels, the first at ({}, {})", blocks.count,
                     blocks.count == 1 ? "" : "s", blocks.first.x, blocks.first.y);
}

FoundGraph find_graph(const ByteImage& image, ByteImage& skeleton, const ImagePage& page,
                      const GraphRequest& request) {
  const Index width = image.width(), height = image.height();
  Pruning pruning = request.pruning;
  std::vector<double> numbers(static_cast<std::size_t>(width * height));
  const View<double> of_image(numbers.data(), width, height);
  distances(image.view(), of_image, pruning.spacing, {.threads = request.threads});
  pruning.distances = of_image;
  FoundGraph found = {page, width, height, {}, {}, {}, pruning.spacing, request.unit, {}};
  found.graph = prune(skeleton.view(), skeleton.view(), pruning, {.threads = request.threads});
  found.widths = edge_widths(found.graph, pruning.distances);
  for (const GraphEdge& edge : found.graph.edges) {
    found.lines.push_back(polyline(points_of(found.graph, edge), request.tolerance, found.spacing));
  }
  if (request.with_main_paths) {
    found.main_paths = main_paths(static_cast<std::uint32_t>(found.graph.nodes.size()),
                                  links_of(found.graph, found.spacing));
  }
  return found;
}

}  // namespace thinbench
