// From contours to the objects that they outline, on packed bits.
#pragma once

#include <vector>

#include "regions/labelled_runs.hpp"

namespace thinbench::detail {

/// An object is an outermost contour, that is, one that touches the outside, with everything it
/// encloses up to the contours inside it. Those inner contours, filled, are its holes.
///
/// Cost: one labelling (labelled_runs.hpp), then two look-ups per run.
class OutlinedObjects {
 public:
  OutlinedObjects(Index width, Index height) : runs_(width, height) {}

  /// Writes all objects to `target`, which has the same size. Does not write margins.
  void write(const ConstBitPlaneView& contours, const BitPlaneView& target);

 private:
  void find_outermost_contours(Index height);
  void find_interiors();
  void write_row(Index y, std::uint64_t* row);

  LabelledRuns runs_;
  std::vector<char> in_object_[2];  // by root; [0] background between contours, [1] contours
};

}  // namespace thinbench::detail
