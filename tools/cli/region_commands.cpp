// thinbench holes and localise: the objects of an image and their holes, as a list, as tables and
// drawn.
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/region_request.hpp"
#include "cli/tables.hpp"
#include "cli/thinbench.hpp"
#include "images/image_file.hpp"
#include "support/json_field.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

struct RegionOptions {
  std::string in;
  std::string overlay;
  std::string csv;
  RegionRequest request;
  bool json = false;
};

void write_files(const RegionOptions& options, const DrawnRegions& drawn) {
  if (!options.csv.empty()) write_whole_file(options.csv, csv_text(regions_json(drawn.found)));
  if (options.request.draws) write_overlay(options.overlay, drawn.ground.view(), drawn.overlay);
}

int run(RegionOptions options, const Console& console) {
  RegionRequest& request = options.request;
  request.draws = !options.overlay.empty();
  if (request.draws) check_overlay_extension(options.overlay);
  check_streams(options.json, {options.overlay});
  check_outputs({options.in}, {options.csv, options.overlay});
  std::ostringstream remarks;  // failures are one line, without them
  GreyImage grey = read_levels(read_input(options.in), request.binarise, remarks);
  BinaryImage binary = binarise(image_to_binarise(grey, request), request.binarise);
  print_remarks(options.in, binary, request.binarise, remarks);
  const DrawnRegions drawn =
      find_regions_in(std::move(grey), std::move(binary), {options.in}, request);
  write_files(options, drawn);
  console.err << remarks.str();
  summary_stream(console, options.overlay)
      << (options.json ? json_text(regions_json(drawn.found)) : regions_list(drawn.found.regions));
  return kSuccess;
}

std::shared_ptr<RegionOptions> add_region_options(CLI::App& app) {
  auto options = std::make_shared<RegionOptions>();
  RegionRequest& request = options->request;
  add_input(app, options->in);
  app.add_flag("--json", options->json, "Print JSON");
  add_file_option(app, "--csv", options->csv, "Table of objects and holes to write", file_name());
  add_overlay_option(app, options->overlay);
  add_value(app, "--min-area", request.min_area,
            "Omit objects and holes of fewer than N pixels, 1 to 2^31",
            whole_number(1, kMaxImagePixels), "N")
      ->capture_default_str();
  add_isa_option(app, request.execution.isa);
  add_threads_option(app, request.execution.threads);
  add_binarise_options(app, request.binarise);
  return options;
}

}  // namespace

Command add_holes_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("holes", "List the objects of an image and their holes");
  const auto options = add_region_options(*app);
  app->footer(R"(Examples:
  thinbench holes parts.png
  thinbench holes parts.jpg --foreground dark --threshold 100 --json > parts.json
  thinbench holes coins.png --min-area 50 --overlay found.png
  thinbench holes coins.png --csv coins.csv --overlay coins.svg

What was taken as foreground, unless you chose it, and what is doubtful about it goes to standard
error. --min-area omits objects of fewer pixels, with all their holes, and holes of fewer pixels
(an object in a hole that is omitted is not). The list, the JSON and the overlay show what remains;
there, objects and holes have ids 1, 2, 3, ... again, in the same order: by their first pixels.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

Command add_localise_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("localise", "List objects and holes of a grey image by their edges");
  const auto options = add_region_options(*app);
  options->request.localises = true;
  add_edge_thresholds(*app, options->request.edges);
  app->footer(R"(Examples:
  thinbench localise parts.png
  thinbench localise parts.png --gradient-threshold 25 --json > parts.json
  thinbench localise parts.jpg --min-area 20 --csv parts.csv --overlay found.svg

Finds edges by Sobel's operator, as 'thinbench edges' does, joins those of one outline, and lists what
they enclose, as 'thinbench holes' does. Areas include the width of the edges; centres move by at most
half a pixel.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
