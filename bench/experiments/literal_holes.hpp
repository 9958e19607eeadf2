// "Hole detection and localisation" (section 2.2): on which images the count of the relabelling
// scan, as published, is correct.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/report.hpp"
#include "support/byte_image.hpp"

namespace thinbench {

struct LiteralHolesChoice {
  int most_holes = 40;
  int thickest_wall = 5;
};

/// One kind of pictures: how many there are, on how many the count is right, and the first on which
/// it is not (or the last one, where all are right).
struct LiteralHolesRow {
  std::string pictures;
  int tried = 0;
  int right = 0;
  int refused = 0;  // more than 254 grey levels needed at once
  int true_holes = 0;
  std::optional<int> counted;  // none where refused
};

/// A plate with holes of one pixel in a row, `wall` pixels from its border and from each other.
[[nodiscard]] ByteImage plate_with_holes(Index holes, Index wall);

/// Plates with 0 to `most_holes` holes, by the thickness of their walls; several objects; the scene
/// of machined parts; and more contours than there are grey levels.
[[nodiscard]] std::vector<LiteralHolesRow> run_literal_holes(const LiteralHolesChoice& choice = {});

[[nodiscard]] ExperimentReport literal_holes_report(const std::vector<LiteralHolesRow>& rows);

}  // namespace thinbench
