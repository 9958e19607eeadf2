// thinbench run: thins one image file into another.
#include <algorithm>
#include <memory>
#include <sstream>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/packed_run.hpp"
#include "cli/packed_tiff.hpp"
#include "cli/summary.hpp"
#include "cli/thinning_request.hpp"
#include "cli/variant_choice.hpp"
#include "harness/operation.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"

namespace thinbench {
namespace {

struct RunOptions {
  ThinningRequest thinning;
  std::string in;
  std::string out;
  BinariseOptions binarise;
  PackedOptions packed;
};

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
  const detail::ThinningOperation& operation = operation_named(options.thinning.operation);
  Options how = options_for(operation, options.thinning);
  if (is_tiff_run(options.packed, options.binarise, options.in, options.out)) {
    return run_tiff(options.packed, operation, options.binarise, options.in, options.out, how,
                    console);
  }
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
  app->add_option("OPERATION", options->thinning.operation,
                  "Name of an operation, see 'thinbench list'")
      ->required()
      ->type_name("");
  app->add_option("IN", options->in, "Image to read")->required()->type_name("");
  app->add_option("OUT", options->out,
                  "Image to write: .png, .pgm, .bmp, .tif or, from PBM (P4), .pbm")
      ->required()
      ->type_name("");
  add_variant_options(*app, options->thinning.how);
  add_thinning_options(*app, options->thinning);
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
  thinbench run thin_guo_hall page.tif skeleton.tif
  thinbench run thin_guo_hall map.pbm skeleton.pbm --out-of-core --memory 256M

OUT holds 255 on the skeleton of the foreground and 0 elsewhere. What was taken as foreground, unless
you chose it, and what is doubtful about it goes to standard error. Images of more than 2^30 pixels
need OPENCV_IO_MAX_IMAGE_PIXELS=2147483648 in the environment. In packed files (.pbm, --raw) 1 is
foreground; they may have up to 2^40 pixels. So may TIFF images of 1 bit per pixel in strips: written to
.tif they remain so, with a white skeleton, and the foreground is chosen as in grey images.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
