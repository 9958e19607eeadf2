#include "images/occupancy_map.hpp"

#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "support/text.hpp"

namespace thinbench {
namespace {

constexpr std::size_t kMaxDescriptionBytes = 100'000;
constexpr std::uint8_t kUnknownLevel = 205;  // as ROS writes it

YAML::Node load(const FileBytes& file) {
  try {
    const YAML::Node root = YAML::Load(std::string(file.text()));
    if (root.IsMap()) return root;
  } catch (const YAML::Exception& error) {
    cannot_read(file.name(), fmt::format("it is not YAML: line {}: {}", error.mark.line + 1,
                                         one_line(error.msg)));
  }
  cannot_read(file.name(), "it describes no map: it has no keys");
}

std::string shown(const YAML::Node& value) {
  if (!value || value.IsNull()) return "nothing";
  if (value.IsScalar()) return fmt::format("'{}'", one_line(value.Scalar().substr(0, 60)));
  return value.IsMap() ? "keys" : "a list of " + counted(value.size(), "value");
}

/// Empty where it is no text.
std::string text(const YAML::Node& value, const std::string& otherwise = {}) {
  if (!value) return otherwise;
  return value.IsScalar() ? value.Scalar() : "";
}

/// Not finite where it is no number.
double number(const YAML::Node& value, double otherwise = NAN) {
  return value ? value.as<double>(NAN) : otherwise;
}

std::array<Index, 256> histogram(const ConstImageView& levels) {
  std::array<Index, 256> counts{};
  for (Index y = 0; y < levels.height; ++y) {
    for (Index x = 0; x < levels.width; ++x) ++counts[levels.row(y)[x]];
  }
  return counts;
}

}  // namespace

bool is_map_description(const std::string& path) {
  return extension_of(path) == ".yaml" || extension_of(path) == ".yml";
}

MapDescription read_map_description(const std::string& path) {
  return parse_map_description(read_file(path, kMaxDescriptionBytes));
}

MapDescription parse_map_description(const FileBytes& file) {
  const YAML::Node keys = load(file);
  const auto require_of = [&](const YAML::Node& value, bool holds, const char* key,
                              const std::string& expected) {
    if (holds) return;
    cannot_read(file.name(), fmt::format("{}: expected {}, got {}", key, expected, shown(value)));
  };
  const auto require = [&](bool holds, const char* key, const std::string& expected) {
    require_of(keys[key], holds, key, expected);
  };
  MapDescription map;
  const std::string image = text(keys["image"]);
  require(!image.empty(), "image", "the name of an image file");
  map.image = std::filesystem::path(file.name()).parent_path() / image;
  map.resolution = number(keys["resolution"]);
  require(std::isfinite(map.resolution) && map.resolution > 0, "resolution",
          "metres per pixel, a number above 0");
  const char* const pose = "[x, y, yaw], three numbers";
  const YAML::Node origin = keys["origin"];
  require(origin && origin.IsSequence() && origin.size() == 3, "origin", pose);
  for (std::size_t i = 0; i < 3; ++i) {
    map.origin[i] = number(origin[i]);
    require_of(origin[i], std::isfinite(map.origin[i]), "origin", pose);
  }
  const double negate = number(keys["negate"], 0);
  require(negate == 0 || negate == 1, "negate", "0 or 1");
  map.negate = negate == 1;
  map.free_thresh = number(keys["free_thresh"], map.free_thresh);
  require(std::isfinite(map.free_thresh), "free_thresh", "a number");
  map.occupied_thresh = number(keys["occupied_thresh"], map.occupied_thresh);
  require(std::isfinite(map.occupied_thresh) && map.occupied_thresh > map.free_thresh,
          "occupied_thresh", fmt::format("a number above free_thresh, {:g}", map.free_thresh));
  require(text(keys["mode"], "trinary") == "trinary", "mode", "trinary");
  return map;
}

bool is_occupancy_map(const GreyImage& image) {
  if (image.is_deep()) return false;
  const auto counts = histogram(image.bytes.view());
  const Index unknown = counts[kUnknownLevel], free = counts[254] + counts[255];
  return unknown > 0 && free > 0 && counts[0] + unknown + free == image.width * image.height;
}

FreeSpace free_space(const ConstImageView& levels, const MapDescription& map,
                     bool unknown_is_free) {
  const auto counts = histogram(levels);
  FreeSpace space = {{}, 0, {}};
  std::array<std::uint8_t, 256> values{};
  for (std::size_t level = 0; level < 256; ++level) {
    const double occupancy = static_cast<double>(map.negate ? level : 255 - level) / 255;
    const bool is_free = occupancy < map.free_thresh;
    const bool is_unknown = !is_free && occupancy <= map.occupied_thresh;
    values[level] = is_free || (is_unknown && unknown_is_free) ? 255 : 0;
    space.unknown += is_unknown ? counts[level] : 0;
    if (is_free && level == kUnknownLevel && counts[level] > 0) {
      space.warning = fmt::format(
          "grey level 205, by which ROS marks what is unknown, is free; "
          "free_thresh is {:g}, and 0.196 makes it unknown",
          map.free_thresh);
    }
  }
  space.image = image_by(levels.width, levels.height,
                         [&](Index x, Index y) { return values[levels.row(y)[x]]; });
  return space;
}

MapPoint point_of(Pixel pixel, const MapDescription& map, Index height) {
  const double x = (pixel.x + 0.5) * map.resolution;
  const double y = (static_cast<double>(height - pixel.y) - 0.5) * map.resolution;
  const double c = std::cos(map.origin[2]), s = std::sin(map.origin[2]);
  return {map.origin[0] + c * x - s * y, map.origin[1] + s * x + c * y};
}

Pixel pixel_at(const MapPoint& point, const MapDescription& map, Index height) {
  const double x = point.x - map.origin[0], y = point.y - map.origin[1];
  const double c = std::cos(map.origin[2]), s = std::sin(map.origin[2]);
  const auto index = [&map](double metres) {
    const double pixels = std::floor(metres / map.resolution);
    return pixels >= 0 && pixels < 1e9 ? static_cast<std::int32_t>(pixels) : -1;
  };
  return {index(c * x + s * y), static_cast<std::int32_t>(height) - 1 - index(c * y - s * x)};
}

}  // namespace thinbench
