// Objects and holes of a grey image: the whole pipeline of section 2 of the paper.
#pragma once

#include "thinbench/edges.hpp"
#include "thinbench/export.h"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Finds edges by Sobel's operator, fills their contours, and returns the regions of the result.
/// Edges are 8-connected rings around outlines. An object is an outermost ring with everything it
/// encloses up to the rings inside it; its holes are those inner rings with everything they
/// enclose. Ids and enclosing objects are those that find_regions gives for the image of these
/// objects.
///
/// Areas include the width of the rings, so objects and holes are too large; centres are unbiased.
/// A ring that is broken by noise, low contrast or the image border encloses nothing and becomes an
/// object as thin as its edges. A hole whose ring touches the outer ring is lost. Each speckle of
/// noise counts as an object or a hole. Objects must be dark on a bright background; see
/// detect_edges, also for the border.
///
/// If `objects` is not 0 x 0, their image is written to it, too: 255 on objects and 0 elsewhere. It
/// must have the size of `grey` and be the same image or share no pixel.
///
/// Thread-safety and errors as in find_regions; also throws std::invalid_argument for a threshold
/// outside [0, 255] and for an image of objects of another size or that overlaps. Nothing is
/// written if it throws.
[[nodiscard]] THINBENCH_API Regions localise_objects(ConstImageView grey,
                                                     const EdgeThresholds& thresholds = {},
                                                     const Execution& execution = {},
                                                     ImageView objects = {});

}  // namespace thinbench
