#include "cli/region_formats.hpp"

#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "support/json_field.hpp"
#include "support/text.hpp"

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

std::string line_of(const char* kind, std::size_t id, const Region& region) {
  return fmt::format("{} {}: area {}, centre ({:.2f}, {:.2f}), box {} {} {} {}\n", kind, id,
                     region.area, region.centre_x(), region.centre_y(), region.left, region.top,
                     region.right - region.left + 1, region.bottom - region.top + 1);
}

/// The positions of each object's holes, by its id.
std::vector<std::vector<std::size_t>> holes_by_object(const Regions& found) {
  std::vector<std::vector<std::size_t>> holes(found.objects.size() + 1);
  for (std::size_t i = 0; i < found.holes.size(); ++i) {
    holes[found.holes[i].enclosing_object].push_back(i);
  }
  return holes;
}

}  // namespace

ForegroundChoice choice_of(const BinaryImage& binary, const BinariseOptions& options) {
  if (options.local) return {binary.foreground, std::nullopt, "local"};
  return {binary.foreground, binary.number(), options.threshold ? "given" : "otsu"};
}

std::string regions_list(const Regions& found) {
  std::string text =
      counted(found.objects.size(), "object") + ", " + counted(found.holes.size(), "hole") + '\n';
  const auto holes_of = holes_by_object(found);
  for (std::size_t i = 0; i < found.objects.size(); ++i) {
    text += line_of("object", i + 1, found.objects[i]);
    for (const std::size_t hole : holes_of[i + 1]) {
      text += line_of("  hole", hole + 1, found.holes[hole]);
    }
  }
  return text;
}

Json regions_json(const FoundRegions& found) {
  const ForegroundChoice& choice = found.choice;
  return {{"file", found.page.file},
          {"page", found.page.page},
          {"width", found.width},
          {"height", found.height},
          {"foreground", foreground_name(choice.foreground)},
          {"threshold", choice.threshold ? json_number(*choice.threshold) : Json()},
          {"threshold_method", choice.method},
          {"min_area", found.min_area},
          {"objects", objects_json(found.regions)}};
}

}  // namespace thinbench
