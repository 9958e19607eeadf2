// From contours to the objects that they outline, on packed bits.
#pragma once

#include <vector>

#include "regions/labelled_runs.hpp"

namespace thinbench::detail {

/// An object is an outermost contour, one that the outside touches, with all that it encloses up to
/// the contours within. Those, filled, are its holes.
///
/// Cost: the image labelled once (labelled_runs.hpp), then two look-ups for each run.
class OutlinedObjects {
 public:
  OutlinedObjects(Index width, Index height) : runs_(width, height) {}

  /// Writes all objects to `target`, of the same size; its margins stay as they are.
  void write(const ConstBitPlaneView& contours, const BitPlaneView& target);

 private:
  void find_outermost(Index height);
  void find_insides();
  void write_row(Index y, std::uint64_t* row);

  LabelledRuns runs_;
  std::vector<char> wanted_[2];  // roots of what lies between contours, and of contours
};

}  // namespace thinbench::detail
