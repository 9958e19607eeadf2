// thinbench path: a path for a robot through a map.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/path_map.hpp"
#include "cli/thinbench.hpp"
#include "images/image_file.hpp"
#include "images/overlay.hpp"
#include "support/json_field.hpp"
#include "support/text.hpp"
#include "thinbench/distance.hpp"
#include "thinbench/path.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

struct PathOptions : PathMapOptions {
  std::string start;
  std::string goal;
  std::string overlay;
  Execution execution;
  bool json = false;
};

std::string path_json(const PathOptions& options, const PathMap& map, const FoundPath& path) {
  Json points = Json::array();
  for (const Pixel p : path.pixels) {
    const MapPoint point = map.point(p);
    points.push_back({json_number(point.x), json_number(point.y)});
  }
  return json_text({{"file", options.in},
                    {"width", map.free.width()},
                    {"height", map.free.height()},
                    {"unit", options.unit},
                    {"robot_width", options.width},
                    {"length", path.length * map.scale()},
                    {"min_width", path.min_width * map.scale()},  // null without an obstacle
                    {"points", points}});
}

std::string path_line(const PathMap& map, const FoundPath& path) {
  const char* const unit = map.metres ? " m" : "";
  return fmt::format("path: {}, length {:.2f}{}, min width {:.2f}{}\n",
                     counted(path.pixels.size(), "pixel"), path.length * map.scale(), unit,
                     path.min_width * map.scale(), unit);
}

/// The path in orange, a light band as wide as the robot around it, start in green and goal in red.
Overlay path_overlay(const std::vector<Pixel>& pixels, double width) {
  const Pixel start = pixels.front(), goal = pixels.back();
  Overlay overlay;
  overlay.lines = {{pixels, {255, 190, 120}, false, width, 0.6, {}},
                   {pixels, {230, 120, 0}, false, 1, 1, {}}};
  overlay.discs = {
      {static_cast<double>(start.x), static_cast<double>(start.y), 4, {40, 160, 60}, "start"},
      {static_cast<double>(goal.x), static_cast<double>(goal.y), 4, {220, 40, 40}, "goal"}};
  return overlay;
}

using Ends = std::array<PathEnd, 2>;

std::optional<FoundPath> path_between(Ends& ends, const PathMap& map, const PathOptions& options,
                                      std::ostream& remarks) {
  const auto give_room_to_both = [&] {
    const ConstImageView free = map.free.view();
    if (std::max(free.width, free.height) > kMaxDistanceSide) return;  // find_path rejects it
    std::vector<double> numbers(static_cast<std::size_t>(free.width * free.height));
    const View<double> view(numbers.data(), free.width, free.height);
    distances(free, view, {}, options.execution);
    for (PathEnd& end : ends) give_room(end, map, view, options, remarks);
  };
  if (options.snap) give_room_to_both();
  try {
    return find_path(map.free.view(), {ends[0].pixel, ends[1].pixel, map.pixels(options.width)},
                     options.execution);
  } catch (const std::invalid_argument&) {
    give_room_to_both();
    throw;
  }
}

FoundPath path_through(const PathMap& map, Ends ends, const PathOptions& options,
                       std::ostream& remarks) {
  try {
    for (PathEnd& end : ends) place_in_map(end, map);
    if (auto path = path_between(ends, map, options, remarks)) return *path;
  } catch (const std::invalid_argument& error) {
    throw FileError(options.in + ": " + error.what() + "; free space is " + map.free_text);
  }
  throw NothingFound(fmt::format("{}: no path from {} to {} is {} wide; free space is {}",
                                 options.in, ends[0].text, ends[1].text,
                                 map.text(map.pixels(options.width)), map.free_text));
}

int run(const PathOptions& options, const Console& console) {
  const auto description = read_description(options);
  const Ends ends = {path_end("--start", options.start, options.in_metres()),
                     path_end("--goal", options.goal, options.in_metres())};
  if (!options.overlay.empty()) check_overlay_extension(options.overlay);
  check_streams(options.json, {options.overlay});
  check_outputs({options.in, description ? description->image : ""}, {options.overlay});
  std::ostringstream remarks;  // failures are one line, without them
  const PathMap map = read_path_map(options, description, remarks);
  const FoundPath path = path_through(map, ends, options, remarks);
  if (!options.overlay.empty()) {
    write_overlay(options.overlay, map.levels.view(),
                  path_overlay(path.pixels, map.pixels(options.width)));
  }
  console.err << remarks.str();
  summary_stream(console, options.overlay)
      << (options.json ? path_json(options, map, path) : path_line(map, path));
  return kSuccess;
}

}  // namespace

Command add_path_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("path", "Find a path for a robot through a map");
  const auto options = std::make_shared<PathOptions>();
  options->binarise.is_mostly_foreground = true;
  add_argument(*app, "MAP", options->in,
               "Image whose foreground is free, or an occupancy map: a description in YAML "
               "(.yaml, .yml) or its image; - reads an image from standard input");
  app->add_option("--start", options->start, "Column and row of the first pixel, or metres")
      ->required()
      ->type_name("X,Y");
  app->add_option("--goal", options->goal, "Column and row of the last pixel, or metres")
      ->required()
      ->type_name("X,Y");
  add_value(*app, "--width", options->width, "Width of the robot, in the unit", real_number(0, 1e6),
            "W")
      ->capture_default_str();
  add_value(*app, "--unit", options->unit,
            "Unit of places, widths and lengths; m needs a description, in whose frame "
            "places are",
            one_of({"pixel", "m"}), "pixel|m")
      ->capture_default_str();
  add_value(*app, "--unknown", options->unknown,
            "What unknown pixels of an occupancy map are (default: obstacle)",
            one_of({"obstacle", "free"}), "obstacle|free");
  app->add_flag("--snap", options->snap,
                "Move a start or goal without room for the robot to the nearest pixel with room");
  app->add_flag("--json", options->json, "Print JSON, with all pixels of the path");
  add_overlay_option(*app, options->overlay);
  add_isa_option(*app, options->execution.isa);
  add_threads_option(*app, options->execution.threads);
  add_binarise_options(*app, options->binarise);
  app->footer(R"(Examples:
  thinbench path plan.png --start 40,150 --goal 590,80
  thinbench path plan.png --start 40,150 --goal 590,80 --width 32 --overlay path.png
  thinbench path map.yaml --unit m --start -1.5,2 --goal 7,0.25 --width 0.5 --snap --overlay path.svg
  thinbench path plan.png --start 40,150 --goal 590,80 --foreground bright --json > path.json

The path has the lowest cost: on the skeleton of the free space, midway between obstacles, a step costs
its length, elsewhere four times its length. Branches of the skeleton that are shorter than the free
space is wide are removed first. All of the path is at least W / 2 from obstacles, between centres of
pixels. What is outside the map is no obstacle. Sides are at most 32767 pixels. Where there is no path,
the exit status is 3.

An occupancy map is one that ROS describes, or an image of the grey levels 0 (obstacle), 205 (unknown)
and 254 or 255 (free) alone, unless --threshold, --foreground, --channel or --blur is given.)");
  return {app, [app, options](const Console& console) {
            for (const char* name : {"--threshold", "--foreground", "--channel", "--blur"}) {
              if (app->count(name) > 0) options->picture_option = name;
            }
            return run(*options, console);
          }};
}

}  // namespace thinbench
