// From contours to the objects that they outline, on packed bits.
#pragma once

#include "core/planes.hpp"
#include "regions/hole_filler.hpp"

namespace thinbench::detail {

/// An object is an outermost contour, that is, one that touches the outside, with everything it
/// encloses up to the contours inside it. Those inner contours, filled, are its holes.
///
/// Cost: that of filling holes three times.
class OutlinedObjects {
 public:
  OutlinedObjects(Isa isa, Index width, Index height);

  /// Writes all objects to `target`, which has the same size. Does not write margins.
  void write(const ConstBitPlaneView& contours, const BitPlaneView& target);

 private:
  HoleFiller eight_;
  HoleFiller four_;
  BitPlane filled_;
  BitPlane inner_;
};

}  // namespace thinbench::detail
