// thinbench graph: the skeleton of an image as a graph.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/graph_request.hpp"
#include "cli/tables.hpp"
#include "cli/thinbench.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "support/json_field.hpp"
#include "support/whole_file.hpp"
#include "thinbench/graph_parts.hpp"

namespace thinbench {
namespace {

struct GraphCommandOptions {
  std::string in;
  std::string image;  // with the widths, instead of `in`
  GraphRequest request;
  BinariseOptions binarise;
  std::string transform;  // empty: by the spacing
  std::vector<std::string> nodes;
  bool has_labels = false;
  bool only_thin = false;
  bool json = false;
  std::string out;
  std::string csv;
  std::string summary;
  std::string geojson;
  std::string overlay;
  std::string edge_labels;
};

AffineTransform transform_of(const GraphCommandOptions& options) {
  const Spacing& spacing = options.request.pruning.spacing;
  if (options.transform.empty()) return {spacing.x, 0, 0, 0, spacing.y, 0};
  AffineTransform transform{};
  const auto numbers = numbers_from(options.transform).value_or(std::vector<double>());
  if (numbers.size() != transform.size()) {
    throw UsageError("--transform: expected six finite numbers such as 1,0,0,0,1,0; got '" +
                     options.transform + "'");
  }
  std::ranges::copy(numbers, transform.begin());
  return transform;
}

void check_names(const GraphCommandOptions& options) {
  if (!options.out.empty()) {
    (options.has_labels ? check_deep_extension : check_extension)(options.out);
  }
  if (!options.overlay.empty()) check_overlay_extension(options.overlay);
  if (!options.edge_labels.empty()) check_deep_extension(options.edge_labels);
  check_streams(options.json, {options.out, options.overlay});
  if (options.out == kStandardStream && options.overlay == kStandardStream) {
    throw UsageError("--out and --overlay cannot both be standard output");
  }
  std::vector<std::string> outputs = {options.csv, options.summary, options.geojson,
                                      options.overlay, options.edge_labels};
  std::error_code ignored;
  const bool replaces = std::filesystem::equivalent(options.in, options.out, ignored);
  if (!replaces) outputs.push_back(options.out);
  check_outputs({options.in, options.image}, outputs);
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

void check_thin(const ByteImage& skeleton, const GraphCommandOptions& options,
                std::ostream& remarks) {
  const std::string thickness = thickness_of(skeleton);
  if (thickness.empty()) return;
  if (options.only_thin) throw FileError(options.in + ": not thin: " + thickness);
  if (options.request.is_skeleton()) {
    remarks << "warning: " << options.in << ": not thin: " << thickness
            << "; they become junctions\n";
  }
}

/// Of --image and of IN.
void check_same_size(const GraphCommandOptions& options, std::pair<Index, Index> size,
                     std::pair<Index, Index> expected) {
  if (size == expected) return;
  throw FileError(fmt::format("{}: expected {} x {} pixels as in {}, got {} x {}", options.image,
                              expected.first, expected.second, options.in, size.first,
                              size.second));
}

/// The image whose distances to the background give the widths.
ByteImage image_of_widths(ByteImage binary, const GraphCommandOptions& options,
                          std::ostream& remarks) {
  if (options.image.empty()) return binary;
  ByteImage image = read_binary(options.image, options.binarise, &remarks);
  check_same_size(options, {image.width(), image.height()}, {binary.width(), binary.height()});
  return image;
}

void write_edge_labels(const std::string& path, const FoundGraph& found) {
  std::vector<std::int32_t> labels(static_cast<std::size_t>(found.width * found.height));
  const LabelView view = {labels.data(), found.width, found.height};
  edge_labels(found.graph, view);
  write_labels(path, view);
}

void write_files(const GraphCommandOptions& options, const FoundGraph& found,
                 const ByteImage& grey) {
  if (!options.csv.empty()) write_whole_file(options.csv, csv_text(graph_json(found)));
  if (!options.summary.empty()) write_whole_file(options.summary, graph_summary(found));
  if (!options.geojson.empty()) {
    const AffineTransform transform = found.place ? found.place->transform : transform_of(options);
    write_whole_file(options.geojson, graph_geojson(found, transform));
  }
  if (!options.overlay.empty()) write_overlay(options.overlay, grey.view(), graph_overlay(found));
  if (!options.edge_labels.empty()) write_edge_labels(options.edge_labels, found);
}

/// Where the list goes: not where an image goes.
std::ostream& list_stream(const Console& console, const GraphCommandOptions& options) {
  return summary_stream(console, options.out == kStandardStream ? options.out : options.overlay);
}

void check_size(const GraphCommandOptions& options, Index width, Index height) {
  check_sides(options.in, width, height);
  check_transform(transform_of(options), options, width, height);
}

/// Coordinates of a map are those of GeoJSON, unless others were asked for.
void take_place(const std::optional<GeoReference>& place, const GraphCommandOptions& options,
                FoundGraph& found, std::ostream& remarks) {
  if (!place || options.geojson.empty() || !options.transform.empty()) return;
  found.place = place;
  const std::string system = place->epsg == 0 ? "" : fmt::format(", EPSG:{}", place->epsg);
  remarks << fmt::format(
      "note: {}: coordinates in {} are those of its GeoTIFF tags{}; --transform "
      "overrides this\n",
      options.in, options.geojson, system);
}

FoundGraph graph_of_image(const GraphCommandOptions& options, std::ostream& remarks) {
  FileBytes file = read_input(options.in);
  check_replaced(file, options.out);
  GreyImage grey = read_levels(std::move(file), options.binarise, remarks);
  check_size(options, grey.width, grey.height);
  const std::optional<GeoReference> place = grey.place;
  const bool draws = !options.overlay.empty();
  BinaryImage binary = binarise(draws ? copy_of(grey) : std::move(grey), options.binarise);
  print_remarks(options.in, binary, options.binarise, remarks);
  ByteImage skeleton = skeleton_of(binary.image, options.request);
  check_thin(skeleton, options, remarks);
  const ByteImage image = image_of_widths(std::move(binary.image), options, remarks);
  FoundGraph found = find_graph(image, skeleton, {options.in}, options.request);
  if (!options.out.empty()) write_grey(options.out, skeleton.view());
  take_place(place, options, found, remarks);
  // NOLINTNEXTLINE(bugprone-use-after-move): where it draws, a copy was moved
  write_files(options, found, draws ? in_bytes(std::move(grey)).bytes : ByteImage());
  return found;
}

/// The objects alone, for the lines that are drawn over them.
ByteImage drawing_of(const LabelPixels& objects) {
  return image_by(objects.width, objects.height,
                  [&](Index x, Index y) { return objects.view().row(y)[x] != 0 ? 255 : 0; });
}

LabelPixels objects_of_widths(LabelPixels labels, const GraphCommandOptions& options) {
  if (options.image.empty()) return labels;
  LabelPixels objects = read_labels(read_input(options.image));
  check_same_size(options, {objects.width, objects.height}, {labels.width, labels.height});
  return objects;
}

FoundGraph graph_of_labelled(const GraphCommandOptions& options, std::ostream& remarks) {
  FileBytes file = read_input(options.in);
  check_replaced(file, options.out);
  LabelPixels labels = read_labels(file);
  check_size(options, labels.width, labels.height);
  LabelPixels skeletons = skeletons_of(labels, options.request);
  const std::optional<GeoReference> place = labels.place;
  const LabelPixels objects = objects_of_widths(std::move(labels), options);
  FoundGraph found = find_graphs(objects, skeletons, {options.in}, options.request);
  if (!options.out.empty()) {
    write_labels(options.out, skeletons.view());
  }
  take_place(place, options, found, remarks);
  write_files(options, found, drawing_of(objects));
  return found;
}

/// The request, with the nodes that its words name.
GraphCommandOptions checked(GraphCommandOptions options) {
  static_cast<void>(transform_of(options));
  check_names(options);
  static_cast<void>(checked_thinning(options.request));
  for (const std::string& node : options.nodes) {
    options.request.nodes.push_back(pixel_from("--node", node));
  }
  return options;
}

int run(const GraphCommandOptions& given, const Console& console) {
  const GraphCommandOptions options = checked(given);
  std::ostringstream remarks;  // failures are one line, without them
  const FoundGraph found =
      options.has_labels ? graph_of_labelled(options, remarks) : graph_of_image(options, remarks);
  console.err << remarks.str();
  list_stream(console, options) << (options.json ? json_text(graph_json(found))
                                                 : graph_list(found));
  return kSuccess;
}

void add_files(CLI::App& app, GraphCommandOptions& options) {
  const auto add = [&app](const char* name, std::string& path, const char* what) {
    return add_file_option(app, name, path, what, file_name());
  };
  app.add_flag("--json", options.json, "Print JSON");
  add("--csv", options.csv, "Table of edges to write");
  add("--summary", options.summary,
      "Table of edges to write, with the columns of skan's summarize");
  CLI::Option* const geojson = add("--geojson", options.geojson, "GeoJSON file to write");
  app.add_option("--transform", options.transform,
                 "A,B,C,D,E,F: GeoJSON has x' = A x + B y + C, y' = D x + E y + F (default: by the "
                 "tags of a GeoTIFF or by the spacing, DX,0,0,0,DY,0)")
      ->needs(geojson)
      ->type_name("NUMBERS");
  add_overlay_option(app, options.overlay);
  add("--edge-labels", options.edge_labels,
      "Label image to write: the id of its edge at each pixel, 0 where edges meet");
  add_value(app, "--out", options.out,
            "Image to write: the skeleton, as pruned; - for PNG on standard output", not_empty(),
            "OUT");
}

}  // namespace

Command add_graph_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("graph", "List ends, junctions and lines of a skeleton");
  const auto options = std::make_shared<GraphCommandOptions>();
  add_input(*app, options->in);
  add_graph_options(*app, options->request);
  add_value(*app, "--node", options->nodes,
            "Make a node of this pixel of the skeleton; may be repeated", not_empty(), "X,Y")
      ->expected(1)
      ->take_all();
  CLI::Option* const labels =
      app->add_flag("--labels", options->has_labels,
                    "IN numbers objects, as `thinbench labels` writes them: a graph for each");
  app->add_flag("--only-thin", options->only_thin,
                "Fail if the skeleton has blocks of 2 x 2 pixels")
      ->excludes(labels);
  add_file_option(*app, "--image", options->image,
                  "Image that gives the widths, where IN is a skeleton made from it");
  add_files(*app, *options);
  add_threads_option(*app, options->request.threads);
  for (CLI::Option* option : add_binarise_options(*app, options->binarise)) {
    option->excludes(labels);
  }
  app->footer(R"(Examples:
  thinbench graph roads.png
  thinbench graph roads.png --prune 10 --overlay roads.svg --csv roads.csv
  thinbench graph roads.png --prune-widths 1 --overlay drawn.png
  thinbench graph roots.png --spacing 0.25 --unit mm --prune 5 --csv roots.csv
  thinbench graph worms.png --main-path --overlay worms.svg
  thinbench graph cells.tif --labels --summary branches.csv
  thinbench graph roads.png --node 120,45 --open-cycles 20
  thinbench graph roads.tif --geojson roads.json --transform 0.5,0,4500000,0,-0.5,5400000
  thinbench graph skeleton.png --thinning none --image roads.png --only-thin --json > graph.json

Ends, junctions and isolated pixels are nodes; lines between them are edges. A closed line without
junctions has a node of its own. Along rows and columns a step has length 1, diagonally sqrt(2). The
width of a line is twice the distance to the background of the image that was thinned; what is
outside the image does not count as background. The main path of a component is the longest of the
shortest paths between two of its nodes or pixels of edges. Sides are at most 32767 pixels. Files are written one
after the other, each whole or not at all.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
