// thinbench holes: the objects of an image and their holes, as a list, as JSON and drawn.
#include <iomanip>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/binarise_options.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "picture/binarise.hpp"
#include "picture/overlay.hpp"
#include "picture/picture.hpp"
#include "picture/region_filter.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench holes parts.png
  thinbench holes parts.jpg --foreground dark --threshold 100 --json > parts.json
  thinbench holes coins.png --min-area 50 --overlay found.png

What was taken as foreground, unless you chose it, and what is doubtful about it goes to standard
error. --min-area omits objects of fewer pixels, with all their holes, and holes of fewer pixels
(an object in a hole that is omitted is not). The list, the JSON and the overlay show what remains;
there, objects and holes have ids 1, 2, 3, ... again, in the same order: by their first pixels.)";

struct HolesCommandOptions {
  std::string in;
  std::string overlay;
  std::string technique;
  std::string isa;
  std::int64_t min_area = 1;
  int threads = 1;
  BinariseOptions binarise;
  bool json = false;
};

using Json = nlohmann::ordered_json;

Json region_json(const Region& region, std::size_t id) {
  return {
      {"id", id},
      {"area", region.area},
      {"centre", {region.centre_x(), region.centre_y()}},
      {"box",
       {region.left, region.top, region.right - region.left + 1, region.bottom - region.top + 1}}};
}

Json objects_json(const Regions& found) {
  Json objects = Json::array();
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    objects.push_back(region_json(found.objects[i], i + 1));
    objects.back()["holes"] = Json::array();
  }
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    const Region& hole = found.holes[i];
    objects[hole.enclosing_object - 1]["holes"].push_back(region_json(hole, i + 1));
  }
  return objects;
}

void print_json(const Regions& found, const BinaryImage& binary, const HolesCommandOptions& options,
                std::ostream& out) {
  const Json json = {{"foreground", foreground_name(binary.foreground)},
                     {"threshold", binary.threshold},
                     {"threshold_method", options.binarise.threshold ? "given" : "otsu"},
                     {"min_area", options.min_area},
                     {"objects", objects_json(found)}};
  out << json.dump(2) << '\n';
}

void print_region(const char* kind, std::size_t id, const Region& region, std::ostream& out) {
  out << kind << ' ' << id << ": area " << region.area << ", centre (" << region.centre_x() << ", "
      << region.centre_y() << "), box " << region.left << ' ' << region.top << ' '
      << region.right - region.left + 1 << ' ' << region.bottom - region.top + 1 << '\n';
}

void print_list(const Regions& found, std::ostream& out) {
  std::vector<std::vector<std::size_t>> holes_of(found.objects.size() + 1);
  for (std::size_t i = 0; i < found.holes.size(); ++i)
    holes_of[found.holes[i].enclosing_object].push_back(i);
  out << std::fixed << std::setprecision(2) << found.objects.size()
      << (found.objects.size() == 1 ? " object, " : " objects, ") << found.holes.size()
      << (found.holes.size() == 1 ? " hole\n" : " holes\n");
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    print_region("object", i + 1, found.objects[i], out);
    for (const std::size_t hole : holes_of[i + 1]) {
      print_region("  hole", hole + 1, found.holes[hole], out);
    }
  }
}

Options options_of(const HolesCommandOptions& options) {
  Options result;
  if (!options.technique.empty()) result.technique = technique_named(options.technique);
  if (!options.isa.empty()) result.isa = isa_named(options.isa);
  result.threads = options.threads;
  return result;
}

Regions found_in(const ByteImage& objects, const Options& options) {
  const auto& operation = detail::operation_of(detail::RegionsTask::holes);
  const detail::RegionsVariant& variant = variant_for(operation, objects.width(), options);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  return find_regions(
      objects.view(),
      {.threads = options.threads, .isa = variant.isa, .technique = variant.technique});
}

int run(const HolesCommandOptions& options, const Console& console) {
  const Options how = options_of(options);
  if (!options.overlay.empty()) check_colour_extension(options.overlay);
  const ByteImage grey = read_grey(options.in);
  const BinaryImage binary = binarise(copy_of(grey.view()), options.binarise);
  const Regions all = found_in(binary.image, how);
  if (!options.overlay.empty()) {
    write_overlay(options.overlay, grey.view(), binary.image.view(), all, options.min_area);
  }
  print_remarks(options.in, binary, options.binarise, console.err);
  const Regions found = selected(all, kept_regions(all, options.min_area));
  if (options.json) {
    print_json(found, binary, options, console.out);
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
  app->add_option("--technique", options->technique, "How to compute (default: the fastest)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option("--isa", options->isa, "Instruction set (default: the highest)")
      ->check(not_empty())
      ->type_name("NAME");
  add_threads_option(*app, options->threads);
  add_binarise_options(*app, options->binarise);
  app->add_option("--min-area", options->min_area,
                  "Omit objects and holes of fewer than N pixels, 1 to 2^31")
      ->check(whole_number(1, kMaxPicturePixels))
      ->type_name("N")
      ->capture_default_str();
  app->footer(kExamples);
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
