// thinbench run: thins one picture file into another.
#include <chrono>
#include <iomanip>
#include <memory>
#include <optional>
#include <string>

#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "cli/weights_option.hpp"
#include "harness/rows.hpp"
#include "picture/objects.hpp"
#include "picture/picture.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench run thin_naccache_shinghal drawing.png skeleton.png
  thinbench run thin_naccache_shinghal parts.jpg skeleton.png --invert --threshold 100
  thinbench run thin_naccache_shinghal big.tif big.tif --technique bitpacked --threads 8
  thinbench run thin_zhang_suen parts.png skeleton.png --border keep
  thinbench run net_two_layer_linear parts.png skeleton.png --weights weights.json
  thinbench run skeleton_scan parts.png marks.png --directions rows,columns

Pictures of more than 2^30 pixels need OPENCV_IO_MAX_IMAGE_PIXELS=2147483648 in the environment.)";

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
  int threshold = kDefaultThreshold;
  bool invert = false;
};

Options thinning_options(const RunOptions& options) {
  Options how;
  if (!options.technique.empty()) how.technique = technique_named(options.technique);
  if (!options.isa.empty()) how.isa = isa_named(options.isa);
  how.threads = options.threads;
  if (!options.border.empty()) how.border = border_named(options.border);
  return how;
}

/// The directions named in a list such as "rows,columns"; none where the list is empty.
std::optional<Directions> directions_named(const ThinningOperation& operation,
                                           const std::string& list) {
  if (list.empty()) return std::nullopt;
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
  int passes;
  double milliseconds;
};

Thinned thinned(const ThinningOperation& operation, const ThinningVariant& variant,
                const ByteImage& objects, const Options& how) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(how.threads));
  ThinningPlan plan(operation, variant, objects.width(), objects.height(),
                    {how.threads, how.model, how.border, how.directions});
  ByteImage skeleton(objects.width(), objects.height());
  const auto start = std::chrono::steady_clock::now();
  const int passes = plan.run(objects.view(), skeleton.view());
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return {std::move(skeleton), passes, time.count()};
}

int run(const RunOptions& options, std::ostream& out) {
  const ThinningOperation& operation = operation_named(options.operation);
  Options how = thinning_options(options);
  how.model = model_from_file(operation, options.weights);
  how.directions = directions_named(operation, options.directions);
  check_ending(options.out);
  const ByteImage objects = objects_of(read_grey(options.in), options.threshold, options.invert);
  how.threads = worthwhile_threads(operation, how, objects.width(), objects.height());
  const ThinningVariant& variant = variant_for(operation, objects.width(), how);
  const Thinned result = thinned(operation, variant, objects, how);
  write_grey(options.out, result.skeleton.view());
  out << row_name(operation.name, technique_name(variant.technique), isa_name(variant.isa),
                  how.threads)
      << ": " << objects.width() << " x " << objects.height() << ", " << result.passes
      << (result.passes == 1 ? " pass, " : " passes, ") << object_pixels(objects.view())
      << " object pixels before, " << object_pixels(result.skeleton.view()) << " after, "
      << std::fixed << std::setprecision(3) << result.milliseconds << " ms\n";
  return kSuccess;
}

}  // namespace

Command add_run_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("run", "Thin a picture file into another");
  const auto options = std::make_shared<RunOptions>();
  app->add_option("OPERATION", options->operation, "Name of an operation, see 'thinbench list'")
      ->required()
      ->type_name("");
  app->add_option("IN", options->in, "Picture to read")->required()->type_name("");
  app->add_option("OUT", options->out, "Picture to write: .png, .pgm, .bmp or .tif")
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
                  "background: all is light outside the picture; keep: the outermost rows and "
                  "columns never change, as in OpenCV (default: the operation's own)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option(
         "--directions", options->directions,
         "Where skeleton_scan looks: rows, columns, diagonals, antidiagonals (default: all)")
      ->check(not_empty())
      ->type_name("NAME,...");
  add_threads_option(*app, options->threads);
  app->add_option("--threshold", options->threshold, "Objects are pixels >= T, 0 to 255")
      ->check(whole_number(0, 255))
      ->type_name("T")
      ->capture_default_str();
  app->add_flag("--invert", options->invert, "Objects are pixels < T instead");
  app->footer(kExamples);
  return {app, [options](const Console& console) { return run(*options, console.out); }};
}

}  // namespace thinbench
