// The paper's whole chain in one header: objects and holes of a grey picture.
#pragma once

#include "edges/thresholds.hpp"
#include "thinbench_holes.hpp"

namespace thinbench {

/// The variant that fits the wish. Throws std::invalid_argument, naming what is wrong and what
/// there is instead, where none does.
[[nodiscard]] const LocaliseVariant& choose_variant(const LocaliseOperation& operation, Index width,
                                                    const VariantRequest& wish = {});

/// Grey levels to Sobel's edges, to contours, to filled interiors, to centres. Edges are
/// 8-connected rings on both sides of outlines. An object is an outermost ring with what it
/// encloses up to the rings within; its holes are those rings, filled with all that they enclose.
/// Numbers and owners are those that find_holes gives on the image of these objects.
///
/// Areas include the rings' width, so objects are too large outside and holes too large, while
/// centres stay. A ring that is open, by noise, weak contrast or the frame, encloses nothing: what
/// is left is an object as thin as its edges. Where a hole's ring touches the outer one, the hole
/// is lost. Each speckle of noise counts as an object, or as a hole. Parts are dark on a bright
/// ground: see detect_edges.
///
/// Throws as find_holes does, and for a threshold outside [0, 255].
[[nodiscard]] FoundHoles localise_objects(ConstImageView grey, const EdgeThresholds& thresholds = {},
                                          const VariantRequest& wish = {});

}  // namespace thinbench
