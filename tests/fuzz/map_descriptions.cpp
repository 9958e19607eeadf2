// Descriptions of occupancy maps: numbers in their ranges, and points and pixels that do not leave
// a map, or one line that says what is wrong.
#include <algorithm>
#include <array>
#include <cmath>

#include "byte_source.hpp"
#include "images/occupancy_map.hpp"

namespace thinbench {
namespace {

void read(const std::string& text) {
  const MapDescription map = parse_map_description({"maps/input.yaml", text});
  must(!map.image.empty(), "a map without an image");
  must(std::isfinite(map.resolution) && map.resolution > 0, "a resolution of no metres");
  must(map.free_thresh < map.occupied_thresh, "thresholds in a wrong order");
  const std::array<std::uint8_t, 4> levels = {0, 205, 254, 255};
  const FreeSpace space = free_space({levels.data(), 4, 1}, map, false);
  must(space.unknown >= 0 && space.unknown <= 4, "more unknown pixels than pixels");
  const auto is_usual = [](double number) { return std::abs(number) <= 1e6; };
  if (map.resolution < 1e-6 || !is_usual(map.resolution)) return;
  if (!std::ranges::all_of(map.origin, is_usual)) return;
  for (const Pixel pixel : {Pixel{0, 0}, Pixel{3, 7}}) {
    must(pixel_at(point_of(pixel, map, 9), map, 9) == pixel,
         "a pixel's centre is in another pixel");
  }
}

}  // namespace

void try_input(ByteSource& input) {
  must_succeed_or_explain<FileError>([&] { read(input.rest()); });
}

}  // namespace thinbench
