// The variants of the operations on objects and holes.
#pragma once

#include <vector>

#include "regions/state.hpp"

namespace thinbench::detail {

/// simd_runs sums squares of columns in 32 bits.
inline constexpr Index kSimdRunsWidth = 65534;

[[nodiscard]] std::vector<RegionsVariant> regions_variants(RegionsTask task);

// Holes and components.
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_bitpacked_runs(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_simd_runs(const RegionsSetting& setting);

// Euler numbers.
[[nodiscard]] std::unique_ptr<RegionsState> make_euler_lut(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_euler_bitpacked(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_euler_simd(const RegionsSetting& setting);

// Filled images.
[[nodiscard]] std::unique_ptr<RegionsState> make_union_find_fill(const RegionsSetting& setting);
[[nodiscard]] std::unique_ptr<RegionsState> make_bitpacked_fill(const RegionsSetting& setting);

}  // namespace thinbench::detail
