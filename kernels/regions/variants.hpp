// The variants of the operations on objects and holes.
#pragma once

#include "regions/state.hpp"

namespace thinbench::detail {

/// The maximum width of simd_runs, which sums squares of columns in 32 bits.
inline constexpr Index kSimdRunsWidth = 65534;

}  // namespace thinbench::detail
