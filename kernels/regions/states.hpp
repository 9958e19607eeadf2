// The makers of all variants, for the table of operations.
#pragma once

#include "regions/variant.hpp"

namespace thinbench::detail {

/// simd_runs sums squares of columns in 32 bits.
inline constexpr Index kSimdRunsWidth = 65534;

// Holes and components.
[[nodiscard]] std::unique_ptr<HolesState> make_union_find(const HolesSetting& setting);
[[nodiscard]] std::unique_ptr<HolesState> make_bitpacked_runs(const HolesSetting& setting);
[[nodiscard]] std::unique_ptr<HolesState> make_simd_runs(const HolesSetting& setting);

// Euler numbers.
[[nodiscard]] std::unique_ptr<HolesState> make_euler_lut(const HolesSetting& setting);
[[nodiscard]] std::unique_ptr<HolesState> make_euler_bitpacked(const HolesSetting& setting);
[[nodiscard]] std::unique_ptr<HolesState> make_euler_simd(const HolesSetting& setting);

// Filled images.
[[nodiscard]] std::unique_ptr<HolesState> make_union_find_fill(const HolesSetting& setting);
[[nodiscard]] std::unique_ptr<HolesState> make_bitpacked_fill(const HolesSetting& setting);

}  // namespace thinbench::detail
