// thinbench holes: the objects of an image and their holes, as a list, as JSON and drawn.
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "cli/names.hpp"
#include "cli/regions_json.hpp"
#include "cli/thinbench.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "images/regions.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

struct HolesCommandOptions {
  std::string in;
  std::string overlay;
  Execution execution;
  std::int64_t min_area = 1;
  BinariseOptions binarise;
  bool json = false;
};

std::string line_of(const char* kind, std::size_t id, const Region& region) {
  return fmt::format("{} {}: area {}, centre ({:.2f}, {:.2f}), box {} {} {} {}\n", kind, id,
                     region.area, region.centre_x(), region.centre_y(), region.left, region.top,
                     region.right - region.left + 1, region.bottom - region.top + 1);
}

void print_list(const Regions& found, std::ostream& out) {
  const auto number = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  out << number(found.objects.size(), "object") << ", " << number(found.holes.size(), "hole")
      << '\n';
  std::vector<std::vector<std::size_t>> holes_of(found.objects.size() + 1);
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    holes_of[found.holes[i].enclosing_object].push_back(i);
  }
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    out << line_of("object", i + 1, found.objects[i]);
    for (const std::size_t hole : holes_of[i + 1]) {
      out << line_of("  hole", hole + 1, found.holes[hole]);
    }
  }
}

int run(const HolesCommandOptions& options, const Console& console) {
  const bool draws = !options.overlay.empty();
  if (draws) check_colour_extension(options.overlay);
  std::ostringstream remarks;  // failures are one line, without them
  ByteImage grey = read_grey(options.in, options.binarise, remarks);
  const ByteImage shown = draws ? copy_of(grey.view()) : ByteImage();
  const BinaryImage binary = binarise(std::move(grey), options.binarise);
  const Regions all = find_regions(binary.image.view(), options.execution);
  if (draws) {
    write_overlay(options.overlay, shown.view(), binary.image.view(), all, options.min_area);
  }
  print_remarks(options.in, binary, options.binarise, remarks);
  console.err << remarks.str();
  const Regions found = selected(all, kept_regions(all, options.min_area));
  if (options.json) {
    console.out << regions_json(found, binary, options.binarise, options.min_area);
  } else {
    print_list(found, console.out);
  }
  return kSuccess;
}

}  // namespace

Command add_holes_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("holes", "List the objects of an image and their holes");
  const auto options = std::make_shared<HolesCommandOptions>();
  app->add_option("IN", options->in, "Image to read")->required()->type_name("");
  app->add_flag("--json", options->json, "Print JSON");
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
