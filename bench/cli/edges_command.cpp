// thinbench edges: marks the edges of one image file in another.
#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "harness/operation.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"

namespace thinbench {
namespace {

struct EdgesOptions {
  std::string in;
  std::string out;
  std::string op = "sobel";
  Options how;
  int gradient_threshold = EdgeThresholds{}.gradient_threshold;
  std::optional<int> brightness_threshold;
  BinariseOptions binarise;
};

const detail::EdgeOperation& operator_named(const std::string& name) {
  if (const auto op = edge_operator_from_name(name)) return detail::operation_of(*op);
  const auto name_of = [](const EdgeOperatorInfo& info) { return info.name; };
  return detail::operation_of(named("operator", name, kEdgeOperators, name_of).op);
}

void invert(ByteImage& grey) {
  for (Index y = 0; y < grey.height(); ++y) {
    std::uint8_t* row = grey.view().row(y);
    for (Index x = 0; x < grey.width(); ++x) row[x] = static_cast<std::uint8_t>(255 - row[x]);
  }
}

/// The image with its background on the bright side, and P2.
struct Prepared {
  ByteImage grey;
  int brightness_threshold;
};

/// Without --brightness-threshold, P2 is the highest grey level of the foreground.
Prepared prepared(const EdgesOptions& options, std::ostream& log) {
  ByteImage grey = read_grey(options.in);
  const BinaryImage binary = binarise(copy_of(grey.view()), options.binarise);
  print_remarks(options.in, binary, options.binarise, log);
  const bool is_bright = binary.foreground == Foreground::bright;
  if (is_bright) invert(grey);
  const int highest = is_bright ? 255 - binary.threshold : std::max(binary.threshold - 1, 0);
  return {std::move(grey), options.brightness_threshold.value_or(highest)};
}

int run(const EdgesOptions& options, const Console& console) {
  const detail::EdgeOperation& operation = operator_named(options.op);
  check_extension(options.out);
  std::ostringstream remarks;  // failures are one line, without them
  const auto [grey, brightness_threshold] = prepared(options, remarks);
  const EdgeThresholds thresholds = {options.gradient_threshold, brightness_threshold};
  const detail::EdgeVariant& variant = variant_for(operation, grey.width(), options.how);
  const auto state =
      make_state(operation, variant, grey.width(), grey.height(), thresholds, options.how);
  ByteImage edges(grey.width(), grey.height());
  const double milliseconds = milliseconds_of(options.how.threads, [&grey = grey, &edges, &state] {
    state->run(grey.view(), edges.view());
  });
  write_grey(options.out, edges.view());
  console.err << remarks.str();
  console.out << fmt::format("{}: {} x {}, {} edge pixels, {:.3f} ms\n",
                             row_name(operation.name, technique_name(variant.technique),
                                      isa_name(variant.isa), options.how.threads),
                             grey.width(), grey.height(), foreground_pixels(edges.view()),
                             milliseconds);
  return kSuccess;
}

void add_thresholds(CLI::App& app, EdgesOptions& options) {
  app.add_option("--gradient-threshold,--p1", options.gradient_threshold,
                 "P1 of the paper: an edge has a greater gradient, 0 to 255")
      ->check(whole_number(0, kMaxThreshold))
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--brightness-threshold,--p2", options.brightness_threshold,
                 "P2 of the paper: beside an edge the background is brighter, 0 to 255 (default: "
                 "from --threshold)")
      ->check(whole_number(0, kMaxThreshold))
      ->type_name("N");
}

}  // namespace

Command add_edges_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("edges", "Mark the edges of an image file in another");
  const auto options = std::make_shared<EdgesOptions>();
  app->add_option("IN", options->in, "Image to read")->required()->type_name("");
  app->add_option("OUT", options->out, "Image to write: .png, .pgm, .bmp or .tif")
      ->required()
      ->type_name("");
  app->add_option("--operator", options->op,
                  "roberts4, roberts9, mero_vassy, mero_vassy_5x5, sobel or prewitt")
      ->type_name("NAME")
      ->capture_default_str();
  add_thresholds(*app, *options);
  add_binarise_options(*app, options->binarise);
  add_variant_options(*app, options->how);
  app->footer(R"(Examples:
  thinbench edges parts.png edges.png
  thinbench edges night.jpg edges.png --operator mero_vassy_5x5 --foreground bright
  thinbench edges parts.png edges.png --gradient-threshold 25 --brightness-threshold 100
  thinbench edges big.tif edges.tif --operator prewitt --threshold 90 --threads 8

An edge pixel has a gradient above P1 (in grey levels: a vertical step of height h reads h) and, in
its 3 x 3 neighbourhood, a pixel above P2. P2 lies below the background, which is the bright side:
where the foreground is bright, the image is inverted first (255 - g for g). By default P2 is the
highest grey level of the foreground, by --threshold, so that all of the background is above it.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
