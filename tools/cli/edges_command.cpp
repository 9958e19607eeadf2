// thinbench edges: marks the edges of one image file in another.
#include <memory>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/edge_request.hpp"
#include "cli/names.hpp"
#include "cli/thinbench.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "support/text.hpp"
#include "support/timing.hpp"

namespace thinbench {
namespace {

struct EdgesOptions {
  std::string in;
  std::string out;
  std::string op = "sobel";
  Execution execution;
  EdgeRequest edges;
  BinariseOptions binarise;
};

EdgeOperator operator_named(const std::string& name) {
  if (const auto op = edge_operator_from_name(name)) return *op;
  const auto name_of = [](const EdgeOperatorInfo& info) { return info.name; };
  return named("operator", name, kEdgeOperators, name_of).op;
}

int run(const EdgesOptions& options, const Console& console) {
  const EdgeOperator op = operator_named(options.op);
  check_extension(options.out);
  FileBytes file = read_input(options.in);
  check_replaced(file, options.out);
  std::ostringstream remarks;  // failures are one line, without them
  GreyImage levels = in_bytes(read_levels(std::move(file), options.binarise, remarks));
  BinaryImage binary = binarise(copy_of(levels), options.binarise);
  ByteImage& grey = levels.bytes;
  print_remarks(options.in, binary, options.binarise, remarks);
  const EdgeThresholds thresholds = prepare_for_edges(grey, binary, options.edges);
  binary.image = {};  // its memory is for the edges
  ByteImage edges(grey.width(), grey.height());
  const double milliseconds = milliseconds_of(
      [&] { detect_edges(op, grey.view(), edges.view(), thresholds, options.execution); });
  write_grey(options.out, edges.view());
  console.err << remarks.str();
  summary_stream(console, options.out) << fmt::format(
      "{}: {} x {}, {}, {:.3f} ms\n", edge_operator_info(op).operation, grey.width(), grey.height(),
      counted(foreground_pixels(edges.view()), "edge pixel"), milliseconds);
  return kSuccess;
}

}  // namespace

Command add_edges_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("edges", "Mark the edges of an image file in another");
  const auto options = std::make_shared<EdgesOptions>();
  add_input(*app, options->in);
  add_argument(*app, "OUT", options->out,
               "Image to write: .png, .pgm, .bmp, .tif, or - for PNG on standard output");
  app->add_option("--operator", options->op,
                  "roberts4, roberts9, mero_vassy, mero_vassy_5x5, sobel or prewitt")
      ->type_name("NAME")
      ->capture_default_str();
  add_edge_thresholds(*app, options->edges);
  add_binarise_options(*app, options->binarise);
  add_isa_option(*app, options->execution.isa);
  add_threads_option(*app, options->execution.threads);
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
