// thinbench graph: the skeleton of an image as a graph.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/graph_formats.hpp"
#include "cli/names.hpp"
#include "cli/thinbench.hpp"
#include "cli/thinning_request.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/whole_file.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

constexpr const char* kNoThinning = "none";

struct GraphCommandOptions {
  std::string in;
  std::string image;  // with the widths, instead of `in`
  std::string thinning = "thin_guo_hall";
  int threads = 1;
  BinariseOptions binarise;
  Pruning pruning;
  double tolerance = 1;
  std::string transform = "1,0,0,0,1,0";
  bool only_thin = false;
  bool json = false;
  std::string out;
  std::string csv;
  std::string geojson;
  std::string overlay;
};

AffineTransform transform_of(const std::string& text) {
  AffineTransform transform{};
  const char* from = text.data();
  const char* const end = from + text.size();
  for (std::size_t i = 0; i < transform.size(); ++i) {
    const auto read = std::from_chars(from, end, transform[i]);
    const bool is_last = i + 1 == transform.size();
    const bool ends_well = is_last ? read.ptr == end : read.ptr != end && *read.ptr == ',';
    if (read.ec != std::errc() || !ends_well || !std::isfinite(transform[i])) {
      throw UsageError("--transform: expected six finite numbers such as 1,0,0,0,1,0; got '" +
                       text + "'");
    }
    from = read.ptr + 1;
  }
  return transform;
}

void check_names(const GraphCommandOptions& options) {
  if (!options.out.empty()) check_extension(options.out);
  if (!options.overlay.empty() && extension_of(options.overlay) != ".svg") {
    throw UsageError("--overlay: expected a name that ends in .svg, got '" + options.overlay + "'");
  }
  const auto place_of = [](const std::string& path) {
    return std::filesystem::weakly_canonical(target_of(path));
  };
  std::vector<std::filesystem::path> known = {place_of(options.in)};
  for (const std::string& path : {options.csv, options.geojson, options.overlay, options.out}) {
    if (path.empty()) continue;
    check_target(path);
    const bool is_in = path == options.out && place_of(path) == known.front();  // read before
    if (!is_in && std::ranges::find(known, place_of(path)) != known.end()) {
      throw UsageError("'" + path + "' is read or written as another file, too; give each its own");
    }
    known.push_back(place_of(path));
  }
}

void check_size(const GraphCommandOptions& options, Index width, Index height) {
  if (std::max(width, height) <= kMaxDistanceSide) return;
  throw FileError(fmt::format("{}: expected sides of at most {} pixels, got {} x {}", options.in,
                              kMaxDistanceSide, width, height));
}

/// Positions of an image of this size must be numbers.
void check_transform(const AffineTransform& transform, const GraphCommandOptions& options,
                     Index width, Index height) {
  const auto& [a, b, c, d, e, f] = transform;
  for (const auto x : {0.0, static_cast<double>(width)}) {
    for (const auto y : {0.0, static_cast<double>(height)}) {
      if (std::isfinite(a * x + b * y + c) && std::isfinite(d * x + e * y + f)) continue;
      throw UsageError("--transform: expected numbers that give finite positions, got '" +
                       options.transform + "'");
    }
  }
}

RequestedThinning skeleton_rule(const GraphCommandOptions& options) {
  ThinningRequest request;
  request.rule = options.thinning;
  return requested_thinning(request);
}

ByteImage skeleton_of(const ByteImage& image, const GraphCommandOptions& options) {
  ByteImage skeleton = copy_of(image.view());
  if (options.thinning != kNoThinning) {
    thin(skeleton_rule(options).rule, image.view(), skeleton.view(), {},
         {.threads = options.threads});
  }
  return skeleton;
}

/// "3 blocks of 2 x 2 pixels, the first at (4, 7)"; empty for thin lines.
std::string thickness_of(const ByteImage& skeleton) {
  const FullBlocks blocks = full_blocks(skeleton.view());
  if (blocks.count == 0) return {};
  return fmt::format("{} block{} of 2 x 2 pixels, the first at ({}, {})", blocks.count,
                     blocks.count == 1 ? "" : "s", blocks.first.x, blocks.first.y);
}

void check_thin(const ByteImage& skeleton, const GraphCommandOptions& options,
                std::ostream& remarks) {
  const std::string thickness = thickness_of(skeleton);
  if (thickness.empty()) return;
  if (options.only_thin) throw FileError(options.in + ": not thin: " + thickness);
  if (options.thinning == kNoThinning) {
    remarks << "warning: " << options.in << ": not thin: " << thickness
            << "; they become junctions\n";
  }
}

/// The image whose distances to the background give the widths.
ByteImage image_of_widths(ByteImage binary, const GraphCommandOptions& options,
                          std::ostream& remarks) {
  if (options.image.empty()) return binary;
  ByteImage image = read_binary(options.image, options.binarise, &remarks);
  if (image.width() == binary.width() && image.height() == binary.height()) return image;
  throw FileError(fmt::format("{}: expected {} x {} pixels as in {}, got {} x {}", options.image,
                              binary.width(), binary.height(), options.in, image.width(),
                              image.height()));
}

FoundGraph graph_of(const ByteImage& image, ByteImage& skeleton,
                    const GraphCommandOptions& options) {
  const Index width = image.width();
  const Index height = image.height();
  std::vector<std::int32_t> squares(static_cast<std::size_t>(width * height));
  squared_distances(image.view(), {squares.data(), width, height}, {.threads = options.threads});
  Pruning pruning = options.pruning;
  pruning.squared_distances = {squares.data(), width, height};
  FoundGraph found = {options.in, width, height, {}, {}, {}};
  found.graph = prune(skeleton.view(), skeleton.view(), pruning, {.threads = options.threads});
  found.widths = edge_widths(found.graph, pruning.squared_distances);
  for (const GraphEdge& edge : found.graph.edges) {
    found.lines.push_back(polyline(points_of(found.graph, edge), options.tolerance));
  }
  return found;
}

int run(const GraphCommandOptions& options, const Console& console) {
  const AffineTransform transform = transform_of(options.transform);
  check_names(options);
  if (options.thinning != kNoThinning) static_cast<void>(skeleton_rule(options));
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage grey = read_grey(options.in, options.binarise, remarks);
  const std::string png = options.overlay.empty() ? "" : png_of(grey.view());
  check_size(options, grey.width(), grey.height());
  check_transform(transform, options, grey.width(), grey.height());
  BinaryImage binary = binarise(std::move(grey), options.binarise);
  print_remarks(options.in, binary, options.binarise, remarks);
  ByteImage skeleton = skeleton_of(binary.image, options);
  check_thin(skeleton, options, remarks);
  const ByteImage image = image_of_widths(std::move(binary.image), options, remarks);
  const FoundGraph found = graph_of(image, skeleton, options);
  if (!options.out.empty()) write_grey(options.out, skeleton.view());
  if (!options.csv.empty()) write_whole_file(options.csv, graph_csv(found));
  if (!options.geojson.empty()) write_whole_file(options.geojson, graph_geojson(found, transform));
  if (!options.overlay.empty()) write_whole_file(options.overlay, graph_svg(found, png));
  console.err << remarks.str();
  console.out << (options.json ? graph_json(found) : graph_list(found));
  return kSuccess;
}

void add_files(CLI::App& app, GraphCommandOptions& options) {
  const auto add = [&app](const char* name, std::string& path, const char* what) {
    app.add_option(name, path, what)->check(not_empty())->type_name("FILE");
  };
  app.add_flag("--json", options.json, "Print JSON");
  add("--csv", options.csv, "Table of edges to write");
  add("--geojson", options.geojson, "GeoJSON file to write");
  app.add_option("--transform", options.transform,
                 "A,B,C,D,E,F: GeoJSON has x' = A x + B y + C, y' = D x + E y + F")
      ->type_name("NUMBERS")
      ->capture_default_str();
  add("--overlay", options.overlay, "SVG file to write: the image with the graph drawn on it");
  add("--out", options.out, "Image to write: the skeleton, as pruned");
}

void add_pruning(CLI::App& app, GraphCommandOptions& options) {
  constexpr double no_limit = 1e9;
  CLI::Option* const prune =
      app.add_option("--prune", options.pruning.min_length, "Remove branches shorter than LENGTH")
          ->check(real_number(0, no_limit))
          ->type_name("LENGTH");
  app.add_option("--prune-widths", options.pruning.min_widths,
                 "Remove branches shorter than N times the object's width at their junction")
      ->check(real_number(0, no_limit))
      ->type_name("N");
  app.add_flag("--remove-components", options.pruning.removes_components,
               "Also remove lines and pixels on their own below LENGTH")
      ->needs(prune);
  app.add_option("--tolerance", options.tolerance,
                 "How far, in pixels, a line may be from the points that are listed for it")
      ->check(real_number(0, no_limit))
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace

Command add_graph_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("graph", "List ends, junctions and lines of a skeleton");
  const auto options = std::make_shared<GraphCommandOptions>();
  add_input(*app, options->in);
  app->add_option("--thinning", options->thinning,
                  "Operation that thins the image; none: it is a skeleton")
      ->check(not_empty())
      ->type_name("NAME")
      ->capture_default_str();
  app->add_flag("--only-thin", options->only_thin,
                "Fail if the skeleton has blocks of 2 x 2 pixels");
  app->add_option("--image", options->image,
                  "Image that gives the widths, where IN is a skeleton made from it")
      ->check(not_empty())
      ->type_name("FILE");
  add_pruning(*app, *options);
  add_files(*app, *options);
  add_threads_option(*app, options->threads);
  add_binarise_options(*app, options->binarise);
  app->footer(R"(Examples:
  thinbench graph roads.png
  thinbench graph roads.png --prune 10 --overlay roads.svg --csv roads.csv
  thinbench graph roads.tif --geojson roads.json --transform 0.5,0,4500000,0,-0.5,5400000
  thinbench graph skeleton.png --thinning none --image roads.png --only-thin --json > graph.json

Ends, junctions and isolated pixels are nodes; lines between them are edges. A closed line without
junctions has a node of its own. Along rows and columns a step has length 1, diagonally sqrt(2). The
width of a line is twice the distance to the background of the image that was thinned; what is
outside the image does not count as background. Sides are at most 32767 pixels. Files are written one
after the other, each whole or not at all.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
