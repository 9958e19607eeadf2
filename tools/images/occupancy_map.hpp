// Occupancy maps of robots, as ROS saves them: an image, and a description of it in YAML.
#pragma once

#include <array>
#include <string>

#include "images/grey_image.hpp"
#include "support/file_bytes.hpp"
#include "thinbench/graph.hpp"

namespace thinbench {

/// What the grey levels of a map stand for, and where its pixels lie. A pixel's occupancy is
/// (255 - level) / 255, or level / 255 where the map is negated.
struct MapDescription {
  std::string image = {};  // the path of its file
  double occupied_thresh = 0.65;
  double free_thresh = 0.25;
  bool negate = false;
  double resolution = 1;  // metres per pixel
  std::array<double, 3> origin =
      {};  // x, y and yaw of the lower left corner of the lower left pixel
};

/// In metres, with y upwards.
struct MapPoint {
  double x;
  double y;
};

/// Whether the name ends in .yaml or .yml.
[[nodiscard]] bool is_map_description(const std::string& path);

/// Throws FileError, which names the key that is missing or wrong.
[[nodiscard]] MapDescription read_map_description(const std::string& path);
[[nodiscard]] MapDescription parse_map_description(const FileBytes& file);

/// Whether an image without description is such a map: its levels are 0, 205 and 254 or 255 alone,
/// and the last two kinds, unknown and free, are there.
[[nodiscard]] bool is_occupancy_map(const GreyImage& image);

struct FreeSpace {
  ByteImage image;      // 255 where free, else 0
  Index unknown;        // pixels that are neither free nor obstacles
  std::string warning;  // of thresholds that do not fit the levels
};

[[nodiscard]] FreeSpace free_space(const ConstImageView& levels, const MapDescription& map,
                                   bool unknown_is_free);

/// The centre of a pixel in a map of this height.
[[nodiscard]] MapPoint point_of(Pixel pixel, const MapDescription& map, Index height);

/// The pixel at a point of a map of this height; a column or row is -1 or beyond the map where the
/// point is outside.
[[nodiscard]] Pixel pixel_at(const MapPoint& point, const MapDescription& map, Index height);

}  // namespace thinbench
