// thinbench run: thins one image file into another.
#include <algorithm>
#include <chrono>
#include <climits>
#include <iomanip>
#include <memory>
#include <sstream>
#include <string>

#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "cli/weights_option.hpp"
#include "harness/rows.hpp"
#include "picture/binarise.hpp"
#include "picture/picture.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench run thin_naccache_shinghal drawing.png skeleton.png
  thinbench run thin_naccache_shinghal parts.jpg skeleton.png --foreground dark --threshold 100
  thinbench run thin_naccache_shinghal big.tif big.tif --technique bitpacked --threads 8
  thinbench run thin_zhang_suen parts.png skeleton.png --border keep --max-iterations 3
  thinbench run net_two_layer_linear parts.png skeleton.png --weights weights.json
  thinbench run skeleton_scan parts.png marks.png --directions rows,columns

OUT holds 255 on the skeleton of the foreground and 0 elsewhere. What was taken as foreground, unless
you chose it, and what is doubtful about it goes to standard error. Images of more than 2^30 pixels
need OPENCV_IO_MAX_IMAGE_PIXELS=2147483648 in the environment.)";

struct RunOptions {
  std::string operation;
  std::string in;
  std::string out;
  std::string technique;
  std::string isa;
  std::string weights;
  std::string border;
  std::string directions;
  int threads = 1;
  int max_iterations = 0;  // 0 for no limit
  BinariseOptions binarise;
};

Options thinning_options(const RunOptions& options) {
  Options how;
  if (!options.technique.empty()) how.technique = technique_named(options.technique);
  if (!options.isa.empty()) how.isa = isa_named(options.isa);
  how.threads = options.threads;
  if (!options.border.empty()) how.border = border_named(options.border);
  if (options.max_iterations > 0) how.max_iterations = options.max_iterations;
  return how;
}

/// The directions named in a list such as "rows,columns"; all where the list is empty.
Directions directions_named(const detail::ThinningOperation& operation, const std::string& list) {
  if (list.empty()) return {};
  if (!operation.takes_directions) {
    throw UsageError("--directions: " + std::string(operation.name) + " is no scan and takes none");
  }
  Directions directions = kNoDirections;
  std::size_t end = 0;
  for (std::size_t start = 0; end != std::string::npos; start = end + 1) {
    end = list.find(',', start);
    const std::string name = list.substr(start, end - start);
    if (name.empty()) {
      throw UsageError("--directions: '" + list + "' names none at one of its commas; known: " +
                       enumeration({kDirectionNames.begin(), kDirectionNames.end()}));
    }
    directions.add(direction_named(name));
  }
  return directions;
}

struct Thinned {
  ByteImage skeleton;
  int iterations;
  double milliseconds;
};

Thinned thinned(const detail::ThinningOperation& operation, const detail::ThinningVariant& variant,
                const ByteImage& objects, const Options& how) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(how.threads));
  const auto state = make_state(operation, variant, objects.width(), objects.height(), how);
  ByteImage skeleton(objects.width(), objects.height());
  const auto start = std::chrono::steady_clock::now();
  const int iterations = state->run(objects.view(), skeleton.view());
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return {std::move(skeleton), iterations, time.count()};
}

/// "90 x 40, 7 iterations, 1200 foreground pixels before, 130 after, 0.042 ms".
std::string summary(const ByteImage& objects, const Thinned& result) {
  std::ostringstream text;
  text << objects.width() << " x " << objects.height() << ", " << result.iterations
       << (result.iterations == 1 ? " iteration, " : " iterations, ")
       << foreground_pixels(objects.view()) << " foreground pixels before, "
       << foreground_pixels(result.skeleton.view()) << " after, " << std::fixed
       << std::setprecision(3) << result.milliseconds << " ms";
  return text.str();
}

int run(const RunOptions& options, const Console& console) {
  const detail::ThinningOperation& operation = operation_named(options.operation);
  Options how = thinning_options(options);
  how.net = net_from_file(operation, options.weights);
  how.directions = directions_named(operation, options.directions);
  check_extension(options.out);
  std::ostringstream remarks;  // failures are one line, without them
  const ByteImage objects = read_binary(options.in, options.binarise, &remarks);
  const bool can_share =
      std::ranges::any_of(operation.variants, &detail::ThinningVariant::threaded);
  how = detail::with_useful_threads(how, can_share, objects.width(), objects.height());
  const detail::ThinningVariant& variant = variant_for(operation, objects.width(), how);
  const Thinned result = thinned(operation, variant, objects, how);
  write_grey(options.out, result.skeleton.view());
  console.err << remarks.str();
  console.out << row_name(operation.name, technique_name(variant.technique), isa_name(variant.isa),
                          how.threads)
              << ": " << summary(objects, result) << '\n';
  return kSuccess;
}

}  // namespace

Command add_run_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("run", "Thin an image file into another");
  const auto options = std::make_shared<RunOptions>();
  app->add_option("OPERATION", options->operation, "Name of an operation, see 'thinbench list'")
      ->required()
      ->type_name("");
  app->add_option("IN", options->in, "Image to read")->required()->type_name("");
  app->add_option("OUT", options->out, "Image to write: .png, .pgm, .bmp or .tif")
      ->required()
      ->type_name("");
  app->add_option("--technique", options->technique, "How to compute (default: the fastest)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option("--isa", options->isa, "Instruction set (default: the highest)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option("--weights", options->weights, "Weights of a net, made by 'thinbench train'")
      ->check(not_empty())
      ->type_name("FILE");
  app->add_option("--border", options->border,
                  "background: outside the image all is background; keep: the outermost rows and "
                  "columns never change, as in OpenCV (default: background)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option(
         "--directions", options->directions,
         "Where skeleton_scan looks: rows, columns, diagonals, antidiagonals (default: all)")
      ->check(not_empty())
      ->type_name("NAME,...");
  app->add_option("--max-iterations", options->max_iterations,
                  "Stop after N iterations (default: when nothing changes any more)")
      ->check(whole_number(1, INT_MAX))
      ->type_name("N");
  add_binarise_options(*app, options->binarise);
  add_threads_option(*app, options->threads);
  app->footer(kExamples);
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
