// What was found, drawn over the image in which it was found.
#pragma once

#include <string>

#include "picture/region_filter.hpp"

namespace thinbench {

/// Writes `grey` with the outlines of objects in green and of holes in red, a cross at each centre
/// of mass (a point where the region is small) and the ids: of objects above their first pixel, of
/// holes beside the centre. Regions smaller than a digit have none. `objects` is the binary
/// image in which `found` was found, with nothing left out; all have one size. Drawn are the
/// regions of at least `min_area` pixels, with the ids that `selected` gives them. The file appears
/// as a whole or not at all. Throws PictureError.
void write_overlay(const std::string& path, const ConstImageView& grey,
                   const ConstImageView& objects, const Regions& found, std::int64_t min_area = 1);

}  // namespace thinbench
