// Objects and holes of a grey image: the whole chain of section 2 of the paper.
#pragma once

#include "thinbench/edges.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Edges by Sobel's operator, their contours, filled interiors, and the regions of these. Edges are
/// 8-connected rings around outlines. An object is an outermost ring with what it encloses up to
/// the rings within; its holes are those rings, filled with all that they enclose. Ids and
/// enclosing objects are those of find_regions on the image of these objects.
///
/// Areas include the width of the rings, so objects and holes are too large; centres are not
/// biased. A ring that is opened by noise, weak contrast or the image border encloses nothing: it
/// becomes an object as thin as its edges. Where a hole's ring touches the outer one, the hole is
/// lost. Each speckle of noise counts as an object or a hole. Objects are dark on a bright
/// background; for this and the border see detect_edges.
///
/// Options, thread safety and errors are those of find_regions; also throws for a threshold outside
/// [0, 255].
[[nodiscard]] Regions localise_objects(ConstImageView grey, const EdgeThresholds& thresholds = {},
                                       const Options& options = {});

}  // namespace thinbench
