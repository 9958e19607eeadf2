// thinbench holes: the objects of an image and their holes, as a list, as tables and drawn.
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "cli/arguments.hpp"
#include "cli/names.hpp"
#include "cli/region_formats.hpp"
#include "cli/thinbench.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "images/regions.hpp"
#include "support/whole_file.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

struct HolesCommandOptions {
  std::string in;
  std::string overlay;
  std::string csv;
  Execution execution;
  std::int64_t min_area = 1;
  BinariseOptions binarise;
  bool json = false;
};

int run(const HolesCommandOptions& options, const Console& console) {
  const bool draws = !options.overlay.empty();
  if (draws) check_colour_extension(options.overlay);
  if (!options.csv.empty()) check_target(options.csv);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage grey = read_grey(options.in, options.binarise, remarks);
  const ByteImage shown = draws ? copy_of(grey.view()) : ByteImage();
  const BinaryImage binary = binarise(std::move(grey), options.binarise);
  const Regions all = find_regions(binary.image.view(), options.execution);
  if (draws) {
    write_overlay(options.overlay, shown.view(), binary.image.view(), all, options.min_area);
  }
  print_remarks(options.in, binary, options.binarise, remarks);
  const FoundRegions found = {options.in, binary.image.width(), binary.image.height(),
                              selected(all, kept_regions(all, options.min_area)), options.min_area};
  if (!options.csv.empty()) write_whole_file(options.csv, regions_csv(found));
  console.err << remarks.str();
  console.out << (options.json ? regions_json(found, choice_of(binary, options.binarise))
                               : regions_list(found.regions));
  return kSuccess;
}

}  // namespace

Command add_holes_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("holes", "List the objects of an image and their holes");
  const auto options = std::make_shared<HolesCommandOptions>();
  app->add_option("IN", options->in, "Image to read; - reads standard input")
      ->required()
      ->type_name("");
  app->add_flag("--json", options->json, "Print JSON");
  app->add_option("--csv", options->csv, "Table of objects and holes to write")
      ->check(not_empty())
      ->type_name("FILE");
  app->add_option("--overlay", options->overlay,
                  "Image to write, with all that was found drawn on it")
      ->check(not_empty())
      ->type_name("OUT");
  add_isa_option(*app, options->execution.isa);
  add_threads_option(*app, options->execution.threads);
  add_binarise_options(*app, options->binarise);
  app->add_option("--min-area", options->min_area,
                  "Omit objects and holes of fewer than N pixels, 1 to 2^31")
      ->check(whole_number(1, kMaxImagePixels))
      ->type_name("N")
      ->capture_default_str();
  app->footer(R"(Examples:
  thinbench holes parts.png
  thinbench holes parts.jpg --foreground dark --threshold 100 --json > parts.json
  thinbench holes coins.png --min-area 50 --overlay found.png

What was taken as foreground, unless you chose it, and what is doubtful about it goes to standard
error. --min-area omits objects of fewer pixels, with all their holes, and holes of fewer pixels
(an object in a hole that is omitted is not). The list, the JSON and the overlay show what remains;
there, objects and holes have ids 1, 2, 3, ... again, in the same order: by their first pixels.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
