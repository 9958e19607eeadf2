// thinbench run: thins one image file into another.
#include <algorithm>
#include <climits>
#include <memory>
#include <sstream>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/packed_run.hpp"
#include "cli/summary.hpp"
#include "cli/variant_choice.hpp"
#include "harness/operation.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "training/weights_file.hpp"

namespace thinbench {
namespace {

struct RunOptions {
  std::string operation;
  std::string in;
  std::string out;
  std::string weights;
  std::string directions;
  Options how;
  BinariseOptions binarise;
  PackedOptions packed;
};

/// The directions named in a list such as "rows,columns"; all where the list is empty.
Directions directions_named(const detail::ThinningOperation& operation, const std::string& list) {
  if (list.empty()) return {};
  if (!operation.takes_directions) {
    throw UsageError("--directions: " + std::string(operation.name) +
                     " is not a scan and has no directions");
  }
  Directions directions = kNoDirections;
  std::size_t end = 0;
  for (std::size_t start = 0; end != std::string::npos; start = end + 1) {
    end = list.find(',', start);
    const std::string name = list.substr(start, end - start);
    if (name.empty()) {
      throw UsageError("--directions: '" + list + "' has an empty name; known: " +
                       enumeration({kDirectionNames.begin(), kDirectionNames.end()}));
    }
    directions.add(direction_named(name));
  }
  return directions;
}

/// The net that `operation` makes of the weights in a file; nullptr where no file is named.
std::shared_ptr<const NetModel> net_from_file(const detail::ThinningOperation& operation,
                                              const std::string& path) {
  if (path.empty()) return nullptr;
  const std::string name(operation.name);
  if (!operation.is_net) {
    throw std::runtime_error("--weights: " + name + " is not a net and has no weights");
  }
  const AnyWeights weights = read_weights(path);
  const bool wants_cluster = operation.rule == Rule::net_single_layer_cluster;
  if (wants_cluster != std::holds_alternative<ClusterWeights>(weights)) {
    const std::string wanted = wants_cluster ? "cluster" : "two_layer";
    throw std::runtime_error(path + ": holds the wrong kind of weights; " + name + " needs " +
                             wanted);
  }
  if (wants_cluster) return cluster_net(std::get<ClusterWeights>(weights));
  const bool is_linear = operation.rule == Rule::net_two_layer_linear;
  return two_layer_net(std::get<TwoLayerWeights>(weights),
                       is_linear ? Activation::linear : Activation::sigmoid);
}

struct Thinned {
  ByteImage skeleton;
  int iterations;
  double milliseconds;
};

Thinned thinned(const detail::ThinningOperation& operation, const detail::ThinningVariant& variant,
                const ByteImage& objects, const Options& how) {
  const auto state = make_state(operation, variant, objects.width(), objects.height(), how);
  Thinned result{ByteImage(objects.width(), objects.height()), 0, 0};
  result.milliseconds = milliseconds_of(
      how.threads, [&] { result.iterations = state->run(objects.view(), result.skeleton.view()); });
  return result;
}

std::string summary(const ByteImage& objects, const Thinned& result) {
  return text_of(RunSummary{objects.width(), objects.height(), result.iterations,
                            foreground_pixels(objects.view()),
                            foreground_pixels(result.skeleton.view()), result.milliseconds});
}

/// Options that choose the foreground among grey levels.
void reject_binarise_options(const BinariseOptions& options) {
  const std::string words = binarise_words(options);
  if (words.empty()) return;
  throw UsageError(words.substr(1, words.find(' ', 1) - 1) +
                   " does not apply to packed files, whose foreground is 1");
}

int run(const RunOptions& options, const Console& console) {
  const detail::ThinningOperation& operation = operation_named(options.operation);
  Options how = options.how;
  how.net = net_from_file(operation, options.weights);
  how.directions = directions_named(operation, options.directions);
  if (is_packed_run(options.packed, options.out)) {
    reject_binarise_options(options.binarise);
    return run_packed(options.packed, operation, options.in, options.out, how, console);
  }
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
  app->add_option("OUT", options->out,
                  "Image to write: .png, .pgm, .bmp, .tif or, from PBM (P4), .pbm")
      ->required()
      ->type_name("");
  add_variant_options(*app, options->how);
  app->add_option("--weights", options->weights, "Weights of a net, made by 'thinbench train'")
      ->check(not_empty())
      ->type_name("FILE");
  app->add_option_function<std::string>(
         "--border",
         [options](const std::string& name) { options->how.border = border_named(name); },
         "background: outside the image all is background; keep: the outermost rows and columns "
         "never change, as in OpenCV (default: background)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option(
         "--directions", options->directions,
         "Where skeleton_scan looks: rows, columns, diagonals, antidiagonals (default: all)")
      ->check(not_empty())
      ->type_name("NAME,...");
  app->add_option("--max-iterations", options->how.max_iterations,
                  "Stop after N iterations (default: when nothing changes any more)")
      ->check(whole_number(1, INT_MAX))
      ->type_name("N");
  add_binarise_options(*app, options->binarise);
  add_packed_options(*app, options->packed);
  app->footer(R"(Examples:
  thinbench run thin_naccache_shinghal drawing.png skeleton.png
  thinbench run thin_naccache_shinghal parts.jpg skeleton.png --foreground dark --threshold 100
  thinbench run thin_naccache_shinghal big.tif big.tif --technique bitpacked --threads 8
  thinbench run thin_zhang_suen parts.png skeleton.png --border keep --max-iterations 3
  thinbench run net_two_layer_linear parts.png skeleton.png --weights weights.json
  thinbench run skeleton_scan parts.png marks.png --directions rows,columns
  thinbench run thin_guo_hall page.pbm skeleton.pbm
  thinbench run thin_guo_hall map.pbm skeleton.pbm --out-of-core --memory 256M

OUT holds 255 on the skeleton of the foreground and 0 elsewhere. What was taken as foreground, unless
you chose it, and what is doubtful about it goes to standard error. Images of more than 2^30 pixels
need OPENCV_IO_MAX_IMAGE_PIXELS=2147483648 in the environment. In packed files (.pbm, --raw) 1 is
foreground; they may have up to 2^40 pixels.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
