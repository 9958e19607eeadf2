#include "localise/outlined_objects.hpp"

#include <algorithm>

namespace thinbench::detail {

void OutlinedObjects::write(const ConstBitPlaneView& contours, const BitPlaneView& target) {
  if (contours.height == 0) return;
  runs_.label(contours);
  find_outermost_contours(contours.height);
  find_interiors();
  for (Index y = 0; y < contours.height; ++y) {
    std::fill_n(target.row(y), target.row_elements, 0);
    write_row(y, target.row(y));
  }
}

/// The first pixel of an outermost contour has the outside as its western neighbour.
void OutlinedObjects::find_outermost_contours(Index height) {
  const Label* const background = runs_.roots(0);
  const Label* const contours = runs_.roots(1);
  in_object_[1].assign(runs_.labels(1), 0);
  for (Index y = 0; y < height; ++y) {
    const RunRow runs = runs_.row(y);
    for (Index i = 1; i < runs.count; i += 2) {
      if (background[runs.labels[i - 1]] == 0) in_object_[1][contours[runs.labels[i]]] = 1;
    }
  }
}

void OutlinedObjects::find_interiors() {
  const Label* const contours = runs_.roots(1);
  in_object_[0].assign(runs_.labels(0), 0);
  for (Label label = 1; label < runs_.labels(0); ++label) {
    in_object_[0][label] = in_object_[1][contours[runs_.contour_of_hole(label)]];
  }
}

void OutlinedObjects::write_row(Index y, std::uint64_t* row) {
  const RunRow runs = runs_.row(y);
  for (Index i = 1; i < runs.count; ++i) {
    const Label root = runs_.roots(static_cast<int>(i % 2))[runs.labels[i]];
    if (in_object_[i % 2][root] != 0) set_run(row, runs, i);
  }
}

}  // namespace thinbench::detail
