// Regions that are large enough to be reported, and how they are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "images/overlay.hpp"
#include "thinbench/regions.hpp"

namespace thinbench {

/// Positions in the lists of a Regions, in increasing order.
struct KeptRegions {
  std::vector<std::size_t> objects;
  std::vector<std::size_t> holes;
};

/// The objects of at least `min_area` pixels, and those of their holes that have as many. Objects
/// that lie in a hole are objects like all others, whatever becomes of the hole and of what
/// encloses it.
[[nodiscard]] KeptRegions kept_regions(const Regions& found, std::int64_t min_area);

/// These regions alone, numbered again from 1 in the same order; enclosing objects have the new
/// numbers.
[[nodiscard]] Regions selected(const Regions& found, const KeptRegions& kept);

/// The outlines of objects in green and of holes in red, a cross at each centre of mass (a point
/// where the region is small) and the ids: of objects above their first pixel, of holes beside the
/// centre. Regions smaller than a digit have none. `objects` is the binary image in which `found`
/// was found, with nothing omitted. Drawn are the regions of at least `min_area` pixels, with the
/// ids that `selected` gives them.
[[nodiscard]] Overlay regions_overlay(const ConstImageView& objects, const Regions& found,
                                      std::int64_t min_area = 1);

}  // namespace thinbench
