// The pipeline of section 2 in plain code: from a grey image to objects and holes.
#pragma once

#include "holes.hpp"
#include "reference.hpp"

namespace thinbench::reference {

/// From 8-connected contours (255) to objects (255): outermost contours with everything they
/// enclose up to the contours inside them. An outermost contour has a 4-neighbour in the outside,
/// the background that is 4-connected to the border.
void outlined_objects(ConstImageView contours, ImageView destination);

/// Edges by `edges`, the objects they outline, and the regions of these: an inner contour, filled,
/// is a hole.
[[nodiscard]] Regions localise_objects(EdgeDetection edges, const EdgeThresholds& thresholds,
                                       ConstImageView source);

}  // namespace thinbench::reference
