// thinbench holes and localise: the objects of an image and their holes, as a list, as tables and
// drawn.
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "cli/arguments.hpp"
#include "cli/edge_request.hpp"
#include "cli/region_formats.hpp"
#include "cli/thinbench.hpp"
#include "images/image_file.hpp"
#include "images/regions.hpp"
#include "support/whole_file.hpp"
#include "thinbench/localise.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

struct RegionOptions {
  std::string in;
  std::string overlay;  // of holes
  std::string csv;
  Execution execution;
  EdgeRequest edges;  // of localise
  BinariseOptions binarise;
  std::int64_t min_area = 1;
  bool json = false;
};

/// Writes what was found by `find(grey, binary)`, which may change both. `grey` is empty unless it
/// is kept.
template <class Find>
int run(const RegionOptions& options, const Console& console, bool keeps_grey, const Find& find) {
  if (!options.csv.empty()) check_target(options.csv);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage grey = read_grey(options.in, options.binarise, remarks);
  const Index width = grey.width(), height = grey.height();
  BinaryImage binary =
      binarise(keeps_grey ? copy_of(grey.view()) : std::move(grey), options.binarise);
  print_remarks(options.in, binary, options.binarise, remarks);
  const Regions all = find(grey, binary);
  const FoundRegions found = {options.in, width, height,
                              selected(all, kept_regions(all, options.min_area)), options.min_area};
  if (!options.csv.empty()) write_whole_file(options.csv, regions_csv(found));
  console.err << remarks.str();
  console.out << (options.json ? regions_json(found, choice_of(binary, options.binarise))
                               : regions_list(found.regions));
  return kSuccess;
}

int run_holes(const RegionOptions& options, const Console& console) {
  const bool draws = !options.overlay.empty();
  if (draws) check_colour_extension(options.overlay);
  return run(options, console, draws, [&](const ByteImage& grey, const BinaryImage& binary) {
    Regions all = find_regions(binary.image.view(), options.execution);
    if (draws) {
      write_overlay(options.overlay, grey.view(), binary.image.view(), all, options.min_area);
    }
    return all;
  });
}

int run_localise(const RegionOptions& options, const Console& console) {
  return run(options, console, true, [&](ByteImage& grey, BinaryImage& binary) {
    const EdgeThresholds thresholds = prepare_for_edges(grey, binary, options.edges);
    binary.image = {};  // its memory is for the edges
    return localise_objects(grey.view(), thresholds, options.execution);
  });
}

std::shared_ptr<RegionOptions> add_region_options(CLI::App& app) {
  const auto options = std::make_shared<RegionOptions>();
  add_input(app, options->in);
  app.add_flag("--json", options->json, "Print JSON");
  app.add_option("--csv", options->csv, "Table of objects and holes to write")
      ->check(not_empty())
      ->type_name("FILE");
  app.add_option("--min-area", options->min_area,
                 "Omit objects and holes of fewer than N pixels, 1 to 2^31")
      ->check(whole_number(1, kMaxImagePixels))
      ->type_name("N")
      ->capture_default_str();
  add_isa_option(app, options->execution.isa);
  add_threads_option(app, options->execution.threads);
  add_binarise_options(app, options->binarise);
  return options;
}

}  // namespace

Command add_holes_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("holes", "List the objects of an image and their holes");
  const auto options = add_region_options(*app);
  app->add_option("--overlay", options->overlay,
                  "Image to write, with all that was found drawn on it")
      ->check(not_empty())
      ->type_name("OUT");
  app->footer(R"(Examples:
  thinbench holes parts.png
  thinbench holes parts.jpg --foreground dark --threshold 100 --json > parts.json
  thinbench holes coins.png --min-area 50 --overlay found.png

What was taken as foreground, unless you chose it, and what is doubtful about it goes to standard
error. --min-area omits objects of fewer pixels, with all their holes, and holes of fewer pixels
(an object in a hole that is omitted is not). The list, the JSON and the overlay show what remains;
there, objects and holes have ids 1, 2, 3, ... again, in the same order: by their first pixels.)");
  return {app, [options](const Console& console) { return run_holes(*options, console); }};
}

Command add_localise_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("localise", "List objects and holes of a grey image by their edges");
  const auto options = add_region_options(*app);
  add_edge_thresholds(*app, options->edges);
  app->footer(R"(Examples:
  thinbench localise parts.png
  thinbench localise parts.png --gradient-threshold 25 --json > parts.json
  thinbench localise parts.jpg --min-area 20 --csv parts.csv

Finds edges by Sobel's operator, as 'thinbench edges' does, joins those of one outline, and lists what
they enclose, as 'thinbench holes' does. Areas include the width of the edges; centres do not move.)");
  return {app, [options](const Console& console) { return run_localise(*options, console); }};
}

}  // namespace thinbench
