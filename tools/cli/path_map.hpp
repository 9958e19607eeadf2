// The map that `thinbench path` reads, a picture or an occupancy map, and places in it, in pixels
// or metres.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "images/binarise.hpp"
#include "images/occupancy_map.hpp"

namespace thinbench {

struct PathMapOptions {
  std::string in;
  std::string unit = "pixel";
  std::string unknown;         // empty: not given
  std::string picture_option;  // one that was given and says how a picture is binarised
  double width = 0;            // of the robot, in the unit
  bool snap = false;           // moves ends without room to room
  BinariseOptions binarise;

  [[nodiscard]] bool in_metres() const { return unit == "m"; }
};

struct PathMap {
  ByteImage levels;  // what an overlay is drawn on
  ByteImage free;    // 255 where free
  std::string free_text;
  std::optional<MapDescription> metres = std::nullopt;  // where the unit is the metre

  /// The length of a pixel in the unit.
  [[nodiscard]] double scale() const { return metres ? metres->resolution : 1; }
  /// A width in the unit as pixels, not rounded up.
  [[nodiscard]] double pixels(double width) const;
  [[nodiscard]] Pixel pixel(const MapPoint& point) const;
  [[nodiscard]] MapPoint point(Pixel pixel) const;

  // A place, and a length in pixels, for people.
  [[nodiscard]] std::string text(Pixel pixel) const;
  [[nodiscard]] std::string text(double pixels) const;
};

/// Nothing where the file is no description. Throws UsageError for options that do not go with it
/// and FileError.
[[nodiscard]] std::optional<MapDescription> read_description(const PathMapOptions& options);

/// The map, with remarks, a line each. Throws FileError.
[[nodiscard]] PathMap read_path_map(const PathMapOptions& options,
                                    const std::optional<MapDescription>& description,
                                    std::ostream& remarks);

/// Start or goal.
struct PathEnd {
  const char* name;
  std::string text;     // as it was given
  MapPoint point = {};  // in the unit
  Pixel pixel = {};
};

/// Throws UsageError.
[[nodiscard]] PathEnd path_end(const char* option, const std::string& text, bool in_metres);

/// Sets the pixel of the end. Throws std::invalid_argument where it is outside the map.
void place_in_map(PathEnd& end, const PathMap& map);

/// Moves an end without room for the robot to the nearest pixel with room, with a remark, or throws
/// std::invalid_argument, which names that. `distances` are those of map.free.
void give_room(PathEnd& end, const PathMap& map, const View<double>& distances,
               const PathMapOptions& options, std::ostream& remarks);

}  // namespace thinbench
