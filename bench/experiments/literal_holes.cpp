#include "experiments/literal_holes.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "holes.hpp"
#include "scene/scene.hpp"
#include "support/text.hpp"

namespace thinbench {
namespace {

constexpr Index kWall = 5;

/// What the scan counts on a binary picture; none where it runs out of grey levels.
std::optional<int> literal_count(const ConstImageView& picture) {
  ByteImage contours(picture.width, picture.height);
  ByteImage levels(picture.width, picture.height);
  reference::contours_of(picture, contours.view());
  try {
    return reference::holes_literal(contours.view(), levels.view()).holes();
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

/// Enters a picture in its row, which shows the first one that is not right.
void enter(LiteralHolesRow& row, const ConstImageView& picture) {
  const auto true_holes = static_cast<int>(reference::holes(picture).holes.size());
  const std::optional<int> counted = literal_count(picture);
  if (row.right == row.tried) {
    row.true_holes = true_holes;
    row.counted = counted;
  }
  ++row.tried;
  row.right += counted == true_holes ? 1 : 0;
  row.refused += counted ? 0 : 1;
}

LiteralHolesRow row_of_plates(const LiteralHolesChoice& choice, int wall) {
  LiteralHolesRow row;
  row.pictures = "one plate, 0 to " + std::to_string(choice.most_holes) + " holes, walls of " +
                 std::to_string(wall) + (wall == 1 ? " pixel" : " pixels");
  for (int holes = 0; holes <= choice.most_holes; ++holes) {
    enter(row, plate_with_holes(holes, wall).view());
  }
  return row;
}

/// Plates one below the other, `kWall` pixels apart.
ByteImage several_plates(Index plates, Index holes) {
  const ByteImage plate = plate_with_holes(holes, kWall);
  const Index pitch = plate.height() + kWall;
  ByteImage image(plate.width(), plates * pitch);
  for (Index y = 0; y < image.height(); ++y) {
    if (y % pitch >= plate.height()) continue;
    for (Index x = 0; x < image.width(); ++x) image.at(x, y) = plate.at(x, y % pitch);
  }
  return image;
}

LiteralHolesRow row_of_several_plates(const LiteralHolesChoice& choice) {
  LiteralHolesRow row;
  row.pictures =
      "2 to 6 plates, 0 to " + std::to_string(choice.most_holes) + " holes each, walls of 5 pixels";
  for (Index plates = 2; plates <= 6; ++plates) {
    for (int holes = 0; holes <= choice.most_holes; ++holes) {
      enter(row, several_plates(plates, holes).view());
    }
  }
  return row;
}

LiteralHolesRow row_of_one(std::string pictures, const ConstImageView& picture) {
  LiteralHolesRow row;
  row.pictures = std::move(pictures);
  enter(row, picture);
  return row;
}

}  // namespace

ByteImage plate_with_holes(Index holes, Index wall) {
  ByteImage image(wall + holes * (wall + 1), 2 * wall + 1);
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) {
      image.at(x, y) = y == wall && x % (wall + 1) == wall ? 0 : 255;
    }
  }
  return image;
}

std::vector<LiteralHolesRow> run_literal_holes(const LiteralHolesChoice& choice) {
  std::vector<LiteralHolesRow> rows;
  for (int wall = 1; wall <= choice.thickest_wall; ++wall) {
    rows.push_back(row_of_plates(choice, wall));
  }
  rows.push_back(row_of_several_plates(choice));
  rows.push_back(row_of_one("the scene of machined parts", render_scene().binary.view()));
  rows.push_back(
      row_of_one("one plate, 254 holes, walls of 5 pixels", plate_with_holes(254, kWall).view()));
  return rows;
}

ExperimentReport literal_holes_report(const std::vector<LiteralHolesRow>& rows) {
  nlohmann::ordered_json json = {{"rows", nlohmann::ordered_json::array()}};
  std::vector<std::vector<std::string>> cells;
  for (const LiteralHolesRow& row : rows) {
    nlohmann::ordered_json entry = {{"pictures", row.pictures},     {"tried", row.tried},
                                    {"right", row.right},           {"refused", row.refused},
                                    {"true_holes", row.true_holes}, {"counted", nullptr}};
    if (row.counted) entry["counted"] = *row.counted;
    json["rows"].push_back(entry);
    cells.push_back({row.pictures, std::to_string(row.tried), std::to_string(row.right),
                     std::to_string(row.refused), std::to_string(row.true_holes),
                     row.counted ? std::to_string(*row.counted) : "refused"});
  }
  return {
      experiment_json("literal-holes", json),
      "Pictures on which the relabelling scan counts holes right, and the first on which it "
      "does not (the last, where all are right):\n\n" +
          markdown_table({"Pictures", "Tried", "Right", "Refused", "Its holes", "Counted"}, cells)};
}

}  // namespace thinbench
