// thinbench holes: the objects of a picture and their holes, as a list, as JSON and drawn.
#include <iomanip>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/names.hpp"
#include "cli/variant_choice.hpp"
#include "picture/objects.hpp"
#include "picture/overlay.hpp"
#include "picture/picture.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {
namespace {

constexpr const char* kExamples = R"(Examples:
  thinbench holes parts.png --invert
  thinbench holes parts.jpg --invert --threshold 100 --json > parts.json
  thinbench holes drawing.png --overlay holes.png)";

struct HolesCommandOptions {
  std::string in;
  std::string overlay;
  std::string technique;
  std::string isa;
  int threads = 1;
  int threshold = kDefaultThreshold;
  bool invert = false;
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

void print_json(const Regions& found, std::ostream& out) {
  Json objects = Json::array();
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    objects.push_back(region_json(found.objects[i], i + 1));
    objects.back()["holes"] = Json::array();
  }
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    const Region& hole = found.holes[i];
    objects[hole.enclosing_object - 1]["holes"].push_back(region_json(hole, i + 1));
  }
  out << Json{{"objects", std::move(objects)}}.dump(2) << '\n';
}

void print_region(const char* kind, std::size_t id, const Region& region, std::ostream& out) {
  out << kind << ' ' << id << ": area " << region.area << ", centre (" << region.centre_x() << ", "
      << region.centre_y() << "), box " << region.left << ' ' << region.top << ' '
      << region.right - region.left + 1 << ' ' << region.bottom - region.top + 1 << '\n';
}

void print_list(const Regions& found, std::ostream& out) {
  std::vector<std::vector<std::size_t>> holes_of(found.objects.size() + 1);
  for (std::size_t i = 0; i < found.holes.size(); ++i) holes_of[found.holes[i].enclosing_object].push_back(i);
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

int find(const HolesCommandOptions& options, std::ostream& out) {
  Options wish;
  if (!options.technique.empty()) wish.technique = technique_named(options.technique);
  if (!options.isa.empty()) wish.isa = isa_named(options.isa);
  wish.threads = options.threads;
  if (!options.overlay.empty()) check_colour_ending(options.overlay);
  const ByteImage grey = read_grey(options.in);
  const HolesVariant& variant = variant_for(*find_holes_operation("holes"), grey.width(), wish);
  const ByteImage objects = objects_of(copy_of(grey.view()), options.threshold, options.invert);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  const Regions found =
      find_regions(objects.view(), {variant.technique, variant.isa, options.threads});
  if (!options.overlay.empty()) {
    write_overlay(options.overlay, grey.view(), objects.view(), found);
  }
  if (options.json) {
    print_json(found, out);
  } else {
    print_list(found, out);
  }
  return kSuccess;
}

}  // namespace

Command add_holes_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("holes", "List the objects of a picture and their holes");
  const auto options = std::make_shared<HolesCommandOptions>();
  app->add_option("IN", options->in, "Picture to read")->required()->type_name("");
  app->add_flag("--json", options->json, "Print JSON");
  app->add_option("--overlay", options->overlay, "Picture to write with all that was found")
      ->check(not_empty())
      ->type_name("OUT");
  app->add_option("--technique", options->technique, "How to compute (default: the fastest)")
      ->check(not_empty())
      ->type_name("NAME");
  app->add_option("--isa", options->isa, "Instruction set (default: the highest)")
      ->check(not_empty())
      ->type_name("NAME");
  add_threads_option(*app, options->threads);
  app->add_option("--threshold", options->threshold, "Objects are pixels >= T, 0 to 255")
      ->check(whole_number(0, 255))
      ->type_name("T")
      ->capture_default_str();
  app->add_flag("--invert", options->invert, "Objects are pixels < T instead");
  app->footer(kExamples);
  return {app, [options](const Console& console) { return find(*options, console.out); }};
}

}  // namespace thinbench
