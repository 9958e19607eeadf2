// Regions that are large enough to be reported.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// These regions alone, numbered again from 1 in the same order; `owner` has the new numbers.
[[nodiscard]] Regions selected(const Regions& found, const KeptRegions& kept);

}  // namespace thinbench
