#include "cli/regions_json.hpp"

#include <nlohmann/json.hpp>

namespace thinbench {
namespace {

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

}  // namespace

std::string regions_json(const Regions& found, const BinaryImage& binary,
                         const BinariseOptions& options, std::int64_t min_area) {
  const Json json = {{"foreground", foreground_name(binary.foreground)},
                     {"threshold", options.local ? Json() : Json(binary.threshold)},
                     {"threshold_method", options.threshold ? "given"
                                          : options.local   ? "local"
                                                            : "otsu"},
                     {"min_area", min_area},
                     {"objects", objects_json(found)}};
  return json.dump(2) + '\n';
}

}  // namespace thinbench
