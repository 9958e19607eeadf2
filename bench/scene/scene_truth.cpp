#include "scene/scene_truth.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kConvention =
    "Pixel centres have integer coordinates: pixel (x, y) covers x - 0.5 to x + 0.5 and y - 0.5 to "
    "y + 0.5, x to the right, y downwards. Lengths are pixels, areas square pixels, of the "
    "outlines "
    "that the image was drawn from. A pixel belongs to a part where grey < threshold. Parts are "
    "the "
    "8-connected components of these pixels, holes the 4-connected components of the others that "
    "do "
    "not touch the image border; ids count both in raster order of their first pixel. The area of "
    "a "
    "part excludes its holes. Area and centre are null where the image border cuts the part off; "
    "its "
    "box then ends at the image border.";

Json point_json(ScenePoint point) {
  return {{"x", point.x}, {"y", point.y}};
}

Json box_json(const SceneBox& box, const Scene& scene) {
  const double right = static_cast<double>(scene.grey.width()) - 0.5;
  const double bottom = static_cast<double>(scene.grey.height()) - 0.5;
  return {{"x_min", std::max(box.x_min, -0.5)},
          {"y_min", std::max(box.y_min, -0.5)},
          {"x_max", std::min(box.x_max, right)},
          {"y_max", std::min(box.y_max, bottom)}};
}

Json part_json(const ScenePart& part, const Scene& scene) {
  return {{"id", part.id},
          {"kind", part.kind},
          {"cut_by_border", part.cut_by_border},
          {"area", part.cut_by_border ? Json() : Json(part.area)},
          {"centre", part.cut_by_border ? Json() : point_json(part.centre)},
          {"box", box_json(part.box, scene)}};
}

Json hole_json(const SceneHole& hole) {
  return {{"id", hole.id},
          {"part", hole.part},
          {"kind", hole.kind},
          {"centre", point_json(hole.centre)},
          {"area", hole.area}};
}

}  // namespace

std::string scene_truth_json(const Scene& scene) {
  Json json = {{"width", scene.grey.width()},  {"height", scene.grey.height()},
               {"threshold", scene.threshold}, {"convention", kConvention},
               {"parts", Json::array()},       {"holes", Json::array()}};
  for (const ScenePart& part : scene.parts) json["parts"].push_back(part_json(part, scene));
  for (const SceneHole& hole : scene.holes) json["holes"].push_back(hole_json(hole));
  return json.dump(2);
}

}  // namespace thinbench
