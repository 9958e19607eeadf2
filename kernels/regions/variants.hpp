// The variants of the operations on objects and holes.
#pragma once

#include <vector>

#include "regions/state.hpp"

namespace thinbench::detail {

/// The maximum width of simd_runs, which sums squares of columns in 32 bits.
inline constexpr Index kSimdRunsWidth = 65534;

[[nodiscard]] std::vector<RegionsVariant> regions_variants(RegionsTask task);

/// States of the technique union_find: for holes and components, and for filling.
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find_fill(const RegionsSetting& setting);

}  // namespace thinbench::detail
