// thinbench edges: marks the edges of one image file in another.
#include <algorithm>
#include <chrono>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "harness/rows.hpp"
#include "picture/binarise.hpp"
#include "picture/picture.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench edges parts.png edges.png
  thinbench edges night.jpg edges.png --operator mero_vassy_5x5 --foreground bright
  thinbench edges parts.png edges.png --gradient-threshold 25 --brightness-threshold 100
  thinbench edges big.tif edges.tif --operator prewitt --threshold 90 --threads 8

An edge pixel has a gradient above P1 (in grey levels: a vertical step of height h reads h) and, in
its 3 x 3 neighbourhood, a pixel above P2. P2 lies below the background, which is the bright side:
where the foreground is bright, the image is inverted first (255 - g for g). By default P2 is the
highest grey level of the foreground, by --threshold, so that all of the background is above it.)";

struct EdgesOptions {
  std::string in;
  std::string out;
  std::string op = "sobel";
  std::string technique;
  std::string isa;
  int gradient_threshold = EdgeThresholds{}.gradient_threshold;
  std::optional<int> brightness_threshold;
  int threads = 1;
  BinariseOptions binarise;
};

const detail::EdgeOperation& operator_named(const std::string& name) {
  if (const auto op = edge_operator_from_name(name)) return detail::operation_of(*op);
  std::vector<std::string_view> known;
  for (const EdgeOperatorInfo& info : kEdgeOperators) known.push_back(info.name);
  reject_name("operator", name, known);
}

Options options_of(const EdgesOptions& options) {
  Options result;
  if (!options.technique.empty()) result.technique = technique_named(options.technique);
  if (!options.isa.empty()) result.isa = isa_named(options.isa);
  result.threads = options.threads;
  return result;
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
  const Options how = options_of(options);
  check_extension(options.out);
  std::ostringstream remarks;  // failures are one line, without them
  const auto [grey, brightness_threshold] = prepared(options, remarks);
  const EdgeThresholds thresholds = {options.gradient_threshold, brightness_threshold};
  const detail::EdgeVariant& variant = variant_for(operation, grey.width(), how);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(how.threads));
  const auto state = make_state(operation, variant, grey.width(), grey.height(), thresholds, how);
  ByteImage edges(grey.width(), grey.height());
  const auto start = std::chrono::steady_clock::now();
  state->run(grey.view(), edges.view());
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  write_grey(options.out, edges.view());
  console.err << remarks.str();
  console.out << row_name(operation.name, technique_name(variant.technique), isa_name(variant.isa),
                          how.threads)
              << ": " << grey.width() << " x " << grey.height() << ", "
              << foreground_pixels(edges.view()) << " edge pixels, " << std::fixed
              << std::setprecision(3) << time.count() << " ms\n";
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
  app->add_option("--technique", options->technique, "How to compute (default: the fastest)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option("--isa", options->isa, "Instruction set (default: the highest)")
      ->check(not_empty())
      ->type_name("NAME");
  add_threads_option(*app, options->threads);
  app->footer(kExamples);
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
