// thinbench localise: objects and holes of a grey image, by their edges.
#include <memory>
#include <sstream>
#include <string>

#include "cli/arguments.hpp"
#include "cli/edge_request.hpp"
#include "cli/region_formats.hpp"
#include "cli/thinbench.hpp"
#include "images/image_file.hpp"
#include "images/regions.hpp"
#include "support/whole_file.hpp"
#include "thinbench/localise.hpp"

namespace thinbench {
namespace {

struct LocaliseOptions {
  std::string in;
  std::string csv;
  Execution execution;
  EdgeRequest edges;
  BinariseOptions binarise;
  std::int64_t min_area = 1;
  bool json = false;
};

int run(const LocaliseOptions& options, const Console& console) {
  if (!options.csv.empty()) check_target(options.csv);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage grey = read_grey(options.in, options.binarise, remarks);
  BinaryImage binary = binarise(copy_of(grey.view()), options.binarise);
  print_remarks(options.in, binary, options.binarise, remarks);
  const EdgeThresholds thresholds = prepare_for_edges(grey, binary, options.edges);
  binary.image = {};  // its memory is for the edges
  const Regions all = localise_objects(grey.view(), thresholds, options.execution);
  const FoundRegions found = {options.in, grey.width(), grey.height(),
                              selected(all, kept_regions(all, options.min_area)), options.min_area};
  if (!options.csv.empty()) write_whole_file(options.csv, regions_csv(found));
  console.err << remarks.str();
  console.out << (options.json ? regions_json(found, choice_of(binary, options.binarise))
                               : regions_list(found.regions));
  return kSuccess;
}

}  // namespace

Command add_localise_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("localise", "List objects and holes of a grey image by their edges");
  const auto options = std::make_shared<LocaliseOptions>();
  app->add_option("IN", options->in, "Image to read; - reads standard input")
      ->required()
      ->type_name("");
  app->add_flag("--json", options->json, "Print JSON");
  app->add_option("--csv", options->csv, "Table of objects and holes to write")
      ->check(not_empty())
      ->type_name("FILE");
  add_edge_thresholds(*app, options->edges);
  app->add_option("--min-area", options->min_area,
                  "Omit objects and holes of fewer than N pixels, 1 to 2^31")
      ->check(whole_number(1, kMaxImagePixels))
      ->type_name("N")
      ->capture_default_str();
  add_isa_option(*app, options->execution.isa);
  add_threads_option(*app, options->execution.threads);
  add_binarise_options(*app, options->binarise);
  app->footer(R"(Examples:
  thinbench localise parts.png
  thinbench localise parts.png --gradient-threshold 25 --json > parts.json
  thinbench localise parts.jpg --min-area 20 --csv parts.csv

Finds edges by Sobel's operator, as 'thinbench edges' does, joins those of one outline, and lists what
they enclose, as 'thinbench holes' does. Areas include the width of the edges; centres do not move.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
