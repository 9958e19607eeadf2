#include "cli/path_map.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/arguments.hpp"
#include "support/text.hpp"
#include "support/usage.hpp"

namespace thinbench {
namespace {

PathMap picture(GreyImage grey, const PathMapOptions& options, std::ostream& remarks) {
  if (!options.unknown.empty()) {
    throw FileError(options.in + ": --unknown is for occupancy maps; " +
                    (options.picture_option.empty()
                         ? "the grey levels of this image are not 0, 205 and 254 or 255"
                         : "with " + options.picture_option + " the image is a picture"));
  }
  BinaryImage binary = binarise(copy_of(grey), options.binarise);
  print_remarks(options.in, binary, options.binarise, remarks);
  return {in_bytes(std::move(grey)).bytes, std::move(binary.image), class_text(binary)};
}

PathMap occupancy_map(GreyImage grey, const MapDescription& description,
                      const PathMapOptions& options, std::ostream& remarks) {
  ByteImage levels = in_bytes(std::move(grey)).bytes;
  const bool unknown_is_free = options.unknown == "free";
  FreeSpace space = free_space(levels.view(), description, unknown_is_free);
  const std::string name = one_line(options.in);
  if (space.unknown > 0 && options.unknown.empty()) {
    remarks << "note: " << name << ": occupancy map; unknown counts as obstacle ("
            << counted(space.unknown, "pixel") << "); --unknown free overrides this\n";
  }
  if (!space.warning.empty()) remarks << "warning: " << name << ": " << space.warning << '\n';
  return {std::move(levels), std::move(space.image),
          unknown_is_free ? fmt::format("occupancy <= {:g}", description.occupied_thresh)
                          : fmt::format("occupancy < {:g}", description.free_thresh)};
}

bool has_room(double distance, double width) {
  return distance > 0 && 2 * distance >= width;
}

double between(Pixel a, Pixel b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Of pixels that are equally near the first by row, then column.
std::optional<Pixel> nearest_with_room(Pixel from, const View<double>& distances, double width) {
  std::optional<Pixel> nearest;
  for (std::int32_t y = 0; y < distances.height; ++y) {
    for (std::int32_t x = 0; x < distances.width; ++x) {
      if (!has_room(distances.row(y)[x], width)) continue;
      if (!nearest || between(from, {x, y}) < between(from, *nearest)) nearest = {x, y};
    }
  }
  return nearest;
}

}  // namespace

double PathMap::pixels(double width) const {
  return metres ? width / scale() * (1 - 1e-12) : width;
}

Pixel PathMap::pixel(const MapPoint& point) const {
  if (metres) return pixel_at(point, *metres, free.height());
  return {static_cast<std::int32_t>(point.x), static_cast<std::int32_t>(point.y)};
}

MapPoint PathMap::point(Pixel pixel) const {
  if (metres) return point_of(pixel, *metres, free.height());
  return {static_cast<double>(pixel.x), static_cast<double>(pixel.y)};
}

std::string PathMap::text(Pixel pixel) const {
  return fmt::format("{:.9g},{:.9g}", point(pixel).x, point(pixel).y);
}

std::string PathMap::text(double pixels) const {
  const std::string number = fmt::format("{:.6g}", pixels * scale());
  return number + (metres ? " m" : number == "1" ? " pixel" : " pixels");
}

std::optional<MapDescription> read_description(const PathMapOptions& options) {
  if (!is_map_description(options.in)) {
    if (!options.in_metres()) return std::nullopt;
    throw UsageError("--unit m: expected a map description, .yaml or .yml, got '" + options.in +
                     "', which does not say how large a pixel is");
  }
  const bool crops = options.binarise.grey.crop.height > 0;
  if (crops || !options.picture_option.empty()) {
    throw UsageError((crops ? "--crop" : options.picture_option) + " is for pictures, and '" +
                     options.in + "' describes an occupancy map");
  }
  return read_map_description(options.in);
}

PathMap read_path_map(const PathMapOptions& options,
                      const std::optional<MapDescription>& description, std::ostream& remarks) {
  FileBytes file = description ? read_file(description->image) : read_input(options.in);
  GreyImage grey = read_levels(std::move(file), options.binarise, remarks);
  if (description) {
    PathMap map = occupancy_map(std::move(grey), *description, options, remarks);
    if (options.in_metres()) map.metres = description;
    return map;
  }
  const bool is_map = options.picture_option.empty() && is_occupancy_map(grey);
  return is_map ? occupancy_map(std::move(grey), {.free_thresh = 0.196}, options, remarks)
                : picture(std::move(grey), options, remarks);
}

PathEnd path_end(const char* option, const std::string& text, bool in_metres) {
  if (!in_metres) {
    const Pixel p = pixel_from(option, text);
    return {option + 2, text, {static_cast<double>(p.x), static_cast<double>(p.y)}};
  }
  const auto numbers = numbers_from(text).value_or(std::vector<double>());
  if (numbers.size() == 2) return {option + 2, text, {numbers[0], numbers[1]}};
  throw UsageError(
      fmt::format("{}: expected X,Y in metres such as 1.5,-2, got '{}'", option, text));
}

void place_in_map(PathEnd& end, const PathMap& map) {
  end.pixel = map.pixel(end.point);
  const auto [x, y] = end.pixel;
  if (x >= 0 && x < map.free.width() && y >= 0 && y < map.free.height()) return;
  const std::string where = map.metres ? fmt::format(" m, which is pixel {},{},", x, y) : "";
  throw std::invalid_argument(fmt::format("{} {}{} is outside the map of {} x {} pixels", end.name,
                                          end.text, where, map.free.width(), map.free.height()));
}

void give_room(PathEnd& end, const PathMap& map, const View<double>& distances,
               const PathMapOptions& options, std::ostream& remarks) {
  const double width = map.pixels(options.width);
  const double distance = distances.row(end.pixel.y)[end.pixel.x];
  if (has_room(distance, width)) return;
  const auto nearest = nearest_with_room(end.pixel, distances, width);
  const std::string there =
      nearest ? map.text(*nearest) + ", " + map.text(between(end.pixel, *nearest)) + " away" : "";
  if (nearest && options.snap) {
    remarks << fmt::format("note: {}: {} {} is moved to {}\n", one_line(options.in), end.name,
                           end.text, there);
    end.text = map.text(*nearest);
    end.pixel = *nearest;
    return;
  }
  const std::string problem = distance == 0 ? "is an obstacle"
                                            : "has room for a width of " + map.text(2 * distance) +
                                                  ", not of " + map.text(width);
  throw std::invalid_argument(
      fmt::format("{} {} {}; {}", end.name, end.text, problem,
                  nearest ? "the nearest pixel with room is " + there + "; --snap moves it there"
                          : "no free pixel has room for a width of " + map.text(width)));
}

}  // namespace thinbench
