// thinbench path: a path for a robot through a map.
#include <cmath>
#include <memory>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/thinbench.hpp"
#include "images/binarise.hpp"
#include "images/image_file.hpp"
#include "images/overlay.hpp"
#include "support/text.hpp"
#include "thinbench/path.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

struct PathOptions {
  std::string in;
  std::string start;
  std::string goal;
  std::string overlay;
  double width = 0;
  Execution execution;
  BinariseOptions binarise;
  bool json = false;
};

std::string path_json(const PathOptions& options, const ByteImage& map, const FoundPath& path) {
  Json pixels = Json::array();
  for (const Pixel p : path.pixels) pixels.push_back({p.x, p.y});
  const Json json = {
      {"file", options.in},     {"width", map.width()},
      {"height", map.height()}, {"robot_width", options.width},
      {"length", path.length},  {"min_width", path.min_width},  // null where there is no obstacle
      {"pixels", pixels}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
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

FoundPath path_through(const BinaryImage& map, const PathRequest& request,
                       const PathOptions& options) {
  std::string reason = fmt::format(
      "no path from {},{} to {},{} is {} wide", request.start.x, request.start.y, request.goal.x,
      request.goal.y, options.width == 1 ? "1 pixel" : fmt::format("{:g} pixels", options.width));
  try {
    if (auto path = find_path(map.image.view(), request, options.execution)) return *path;
  } catch (const std::invalid_argument& error) {
    reason = error.what();
  }
  throw FileError(options.in + ": " + reason + "; free space is " + class_text(map));
}

int run(const PathOptions& options, const Console& console) {
  const PathRequest request = {pixel_from("--start", options.start),
                               pixel_from("--goal", options.goal), options.width};
  if (!options.overlay.empty()) check_overlay_extension(options.overlay);
  check_streams(options.json, {options.overlay});
  check_outputs({options.in}, {options.overlay});
  std::ostringstream remarks;  // failures are one line, without them
  GreyImage grey = read_levels(read_input(options.in), options.binarise, remarks);
  const BinaryImage map = binarise(copy_of(grey), options.binarise);
  print_remarks(options.in, map, options.binarise, remarks);
  const FoundPath path = path_through(map, request, options);
  if (!options.overlay.empty()) {
    write_overlay(options.overlay, in_bytes(std::move(grey)).bytes.view(),
                  path_overlay(path.pixels, options.width));
  }
  console.err << remarks.str();
  summary_stream(console, options.overlay)
      << (options.json
              ? path_json(options, map.image, path)
              : fmt::format("path: {}, length {:.2f}, min width {:.2f}\n",
                            counted(path.pixels.size(), "pixel"), path.length, path.min_width));
  return kSuccess;
}

}  // namespace

Command add_path_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("path", "Find a path for a robot through a map");
  const auto options = std::make_shared<PathOptions>();
  options->binarise.is_mostly_foreground = true;
  app->add_option("MAP", options->in, "Image whose foreground is free; - reads standard input")
      ->required()
      ->type_name("");
  app->add_option("--start", options->start, "Column and row of the first pixel")
      ->required()
      ->type_name("X,Y");
  app->add_option("--goal", options->goal, "Column and row of the last pixel")
      ->required()
      ->type_name("X,Y");
  app->add_option("--width", options->width, "Width of the robot in pixels")
      ->check(real_number(0, 1e6))
      ->type_name("W")
      ->capture_default_str();
  app->add_flag("--json", options->json, "Print JSON, with all pixels of the path");
  add_overlay_option(*app, options->overlay);
  add_isa_option(*app, options->execution.isa);
  add_threads_option(*app, options->execution.threads);
  add_binarise_options(*app, options->binarise);
  app->footer(R"(Examples:
  thinbench path plan.png --start 40,150 --goal 590,80
  thinbench path plan.png --start 40,150 --goal 590,80 --width 32 --overlay path.png
  thinbench path plan.png --start 40,150 --goal 590,80 --width 32 --overlay path.svg
  thinbench path plan.png --start 40,150 --goal 590,80 --foreground bright --json > path.json

The path has the least cost: on the skeleton of the free space, midway between obstacles, a step costs
its length, elsewhere four times its length. Branches of the skeleton that are shorter than the free
space is wide are removed first. All of the path is at least W / 2 from obstacles, between centres of
pixels. What is outside the map is no obstacle. Sides are at most 32767 pixels.)");
  return {app, [options](const Console& console) { return run(*options, console); }};
}

}  // namespace thinbench
