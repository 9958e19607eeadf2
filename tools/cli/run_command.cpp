// thinbench run: thins one image file into another.
#include <algorithm>
#include <memory>
#include <string>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/packed_run.hpp"
#include "cli/packed_tiff.hpp"
#include "cli/scan_request.hpp"
#include "cli/thinbench.hpp"
#include "cli/thinning_request.hpp"
#include "cli/thinning_run.hpp"
#include "support/usage.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/thinning.hpp"

namespace thinbench {
namespace {

struct RunOptions {
  ThinningRequest thinning;
  ThinningFiles files;
  BinariseOptions binarise;
  PackedOptions packed;
  Options of_binarise;  // some were given
};

/// Of operations that other commands do.
void reject_other_commands(const std::string& word) {
  const auto use = [&word](const std::string& command) {
    throw UsageError("run applies rules; '" + word + "' is done by 'thinbench " + command + "'");
  };
  for (const EdgeOperatorInfo& info : kEdgeOperators) {
    if (word == info.operation) use("edges --operator " + std::string(info.name));
  }
  std::string command = word;
  std::replace(command.begin(), command.end(), '_', '-');
  if (command == "euler-number") command = "euler";
  if (command == "localise-objects") command = "localise";
  for (const char* name : {"edges", "holes", "localise", "fill-holes", "labels", "distance",
                           "euler", "graph", "path", "batch"}) {
    if (command == name) use(name);
  }
}

int run_scan(const RunOptions& options, const Console& console) {
  const RequestedScan scan = requested_scan(options.thinning);
  if (is_packed_run(options.packed, options.files.out)) {
    throw UsageError(std::string(kScanOperation) + " does not take packed files");
  }
  const auto& [in, out] = options.files;
  FileBytes file = read_input(in);
  check_replaced(file, out);
  const auto apply = [&](const ImageView& image) {
    scan.run(image);
    return 1;
  };
  return run_image(kScanOperation, apply, std::move(file), out, options.binarise, console);
}

int run(const RunOptions& options, const Console& console) {
  reject_other_commands(options.thinning.rule);
  if (makes_scan(options.thinning)) return run_scan(options, console);
  const RequestedThinning thinning = requested_thinning(options.thinning);
  check_options(thinning);
  const auto& [in, out] = options.files;
  const bool is_packed = is_packed_run(options.packed, out);
  if (is_packed) reject_for_packed_files(options.of_binarise);
  FileBytes file = read_input(in);
  check_replaced(file, out);
  if (is_packed) return run_packed(options.packed, thinning, std::move(file), out, console);
  if (auto page = packed_tiff(options.packed, options.binarise, file, out)) {
    file = {};
    return run_tiff(thinning, options.binarise, std::move(*page), options.files, console);
  }
  const auto apply = [&](const ImageView& image) {
    return thin(thinning.rule, image, image, thinning.thinning, thinning.execution);
  };
  return run_image(thinning.name, apply, std::move(file), out, options.binarise, console);
}

}  // namespace

Command add_run_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("run", "Thin an image file into another, or apply any rule");
  const auto options = std::make_shared<RunOptions>();
  options->thinning.other_operations = {kScanOperation};
  add_argument(*app, "RULE", options->thinning.rule,
               "Operation ('thinbench list'), named rule ('thinbench rule --list'), Hensel's "
               "notation such as B3/S23, or JSON file");
  add_input(*app, options->files.in);
  add_argument(*app, "OUT", options->files.out,
               "Image to write: .png, .pgm, .bmp, .tif, - for PNG on standard output or, from PBM "
               "(P4), .pbm");
  add_isa_option(*app, options->thinning.execution.isa);
  add_threads_option(*app, options->thinning.execution.threads);
  add_thinning_options(*app, options->thinning);
  options->of_binarise = add_binarise_options(*app, options->binarise);
  add_packed_options(*app, options->packed);
  app->footer(R"(Examples:
  thinbench run thin_naccache_shinghal drawing.png skeleton.png
  thinbench run thin_naccache_shinghal parts.jpg skeleton.png --foreground dark --threshold 100
  thinbench run thin_naccache_shinghal big.tif big.tif --threads 8
  thinbench run thin_zhang_suen parts.png skeleton.png --border keep --max-iterations 3
  thinbench run net_two_layer_linear parts.png skeleton.png --weights weights.json
  thinbench run midpoint_scan parts.png marks.png --directions rows,columns
  thinbench run majority parts.jpg smooth.png --foreground dark
  thinbench run B3/S23 parts.png life.png --max-iterations 100
  thinbench run my_rule.json parts.png out.png --border foreground --optimise
  thinbench run thin_guo_hall page.pbm skeleton.pbm
  thinbench run thin_guo_hall page.tif skeleton.tif

OUT holds 255 on the skeleton of the foreground and 0 elsewhere. What was taken as foreground, unless
you chose it, and what is doubtful about it goes to standard error. In packed files (.pbm, --raw) 1 is
foreground; they may have up to 2^40 pixels. So may upright TIFF images of 1 bit per pixel in strips:
written to .tif they remain so, with a white skeleton, and the foreground is chosen as in grey images.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
