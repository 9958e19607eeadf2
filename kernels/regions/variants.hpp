// The variants of the operations on objects and holes.
#pragma once

#include <vector>

#include "regions/state.hpp"

namespace thinbench::detail {

/// simd_runs sums up squares of columns in 32 bits.
inline constexpr Index kSimdRunsWidth = 65534;

[[nodiscard]] std::vector<RegionsVariant> regions_variants(RegionsTask task);

/// The technique union_find: holes and components, and filled images.
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find_fill(const RegionsSetting& setting);

}  // namespace thinbench::detail
