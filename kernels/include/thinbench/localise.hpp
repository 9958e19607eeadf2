// The paper's whole chain: objects and holes of a grey image.
#pragma once

#include "thinbench/edges.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Grey levels to Sobel's edges, to contours, to filled interiors, to centres. Edges are
/// 8-connected rings on both sides of outlines. An object is an outermost ring with what it
/// encloses up to the rings within; its holes are those rings, filled with all that they enclose.
/// Numbers and enclosing objects are those that find_regions gives on the image of these objects.
///
/// Areas include the rings' width, so objects and holes are too large, while centres stay. A ring
/// that is open, by noise, weak contrast or the image border, encloses nothing: what remains is an
/// object as thin as its edges. Where a hole's ring touches the outer one, the hole is lost. Each
/// speckle of noise counts as an object, or as a hole. Objects are dark on a bright ground: see
/// detect_edges.
///
/// Options, thread safety and errors: as find_regions, and for a threshold outside [0, 255].
[[nodiscard]] Regions localise_objects(ConstImageView grey, const EdgeThresholds& thresholds = {},
                                       const Options& options = {});

}  // namespace thinbench
