// Regions that are large enough to be reported, and drawn over the image in which they were found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

/// Writes `grey` with the outlines of objects in green and of holes in red, a cross at each centre
/// of mass (a point where the region is small) and the ids: of objects above their first pixel, of
/// holes beside the centre. Regions smaller than a digit have none. `objects` is the binary
/// image in which `found` was found, with nothing omitted; all have one size. Drawn are the
/// regions of at least `min_area` pixels, with the ids that `selected` gives them. The file appears
/// as a whole or not at all. Throws FileError.
void write_overlay(const std::string& path, const ConstImageView& grey,
                   const ConstImageView& objects, const Regions& found, std::int64_t min_area = 1);

}  // namespace thinbench
