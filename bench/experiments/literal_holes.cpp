// Holes as the paper counts them, on images whose holes are known.
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/experiments.hpp"
#include "holes.hpp"
#include "scene/scene.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

using Json = nlohmann::ordered_json;

constexpr Index kWall = 5;
constexpr int kMaxHoles = 40;

/// A plate with holes of one pixel in a row, `wall` pixels from its border and from each other.
ByteImage plate_with_holes(Index holes, Index wall) {
  return image_by(wall + holes * (wall + 1), 2 * wall + 1, [wall](Index x, Index y) {
    return y == wall && x % (wall + 1) == wall ? 0 : 255;
  });
}

/// What the scan counts on a binary image; none where it runs out of grey levels.
std::optional<int> literal_count(const ConstImageView& image) {
  ByteImage contours(image.width, image.height);
  ByteImage levels(image.width, image.height);
  reference::contours_of(image, contours.view());
  try {
    return reference::holes_literal(contours.view(), levels.view()).holes();
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

/// On how many images of a kind the count is right, and the first on which it is not (the last one,
/// where all are right).
class Tried {
 public:
  void enter(const ConstImageView& image) {
    const auto true_holes = static_cast<int>(reference::holes(image).holes.size());
    const std::optional<int> counted = literal_count(image);
    if (right_ == tried_) {
      true_holes_ = true_holes;
      counted_ = counted;
    }
    ++tried_;
    right_ += counted == true_holes ? 1 : 0;
    rejected_ += counted ? 0 : 1;
  }

  [[nodiscard]] Json row(const std::string& images) const {
    return {{"pictures", images},        {"tried", tried_},
            {"right", right_},           {"rejected", rejected_},
            {"true_holes", true_holes_}, {"counted", counted_ ? Json(*counted_) : Json()}};
  }

 private:
  int tried_ = 0;
  int right_ = 0;
  int rejected_ = 0;  // more than 254 grey levels needed at once
  int true_holes_ = 0;
  std::optional<int> counted_;  // none where rejected
};

Json row_of_plates(int wall) {
  Tried plates;
  for (int holes = 0; holes <= kMaxHoles; ++holes) {
    plates.enter(plate_with_holes(holes, wall).view());
  }
  return plates.row(
      fmt::format("one plate, 0 to {} holes, walls of {}", kMaxHoles, counted(wall, "pixel")));
}

/// Plates one below the other, `kWall` pixels apart.
ByteImage several_plates(Index plates, Index holes) {
  const ByteImage plate = plate_with_holes(holes, kWall);
  const Index pitch = plate.height() + kWall;
  return image_by(plate.width(), plates * pitch, [&](Index x, Index y) {
    return y % pitch < plate.height() ? plate.at(x, y % pitch) : 0;
  });
}

Json row_of_several_plates() {
  Tried images;
  for (Index plates = 2; plates <= 6; ++plates) {
    for (int holes = 0; holes <= kMaxHoles; ++holes) {
      images.enter(several_plates(plates, holes).view());
    }
  }
  return images.row(
      fmt::format("2 to 6 plates, 0 to {} holes each, walls of {} pixels", kMaxHoles, kWall));
}

Json row_of_one(const std::string& name, const ConstImageView& image) {
  Tried one;
  one.enter(image);
  return one.row(name);
}

}  // namespace

ExperimentReport literal_holes() {
  Json rows = Json::array();
  for (int wall = 1; wall <= kWall; ++wall) rows.push_back(row_of_plates(wall));
  rows.push_back(row_of_several_plates());
  rows.push_back(row_of_one("the scene of machined parts", render_scene().binary.view()));
  rows.push_back(
      row_of_one("one plate, 254 holes, walls of 5 pixels", plate_with_holes(254, kWall).view()));
  return report_of(
      "literal-holes",
      "Images on which the relabelling scan counts holes right, and the first on which "
      "it does not (the last, where all are right):",
      {{"rows", rows}});
}

}  // namespace thinbench
