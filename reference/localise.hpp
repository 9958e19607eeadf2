// The chain of section 2 in plain code: a grey picture to objects and holes.
#pragma once

#include "holes.hpp"
#include "reference.hpp"

namespace thinbench::reference {

/// 255 on objects, of which 8-connected contours (255) are given: on outermost contours and on what
/// they enclose up to the contours within. Outermost are contours with a pixel beside the outside,
/// and the outside is what reaches the border by steps to the west, north, east or south.
void outlined_objects(ConstImageView contours, ImageView destination);

/// Edges by `edges`, the objects that they outline, and the regions of those: a contour within
/// another, filled, is a hole.
[[nodiscard]] Regions localise_objects(EdgeDetection edges, const EdgeThresholds& thresholds,
                                       ConstImageView source);

}  // namespace thinbench::reference
