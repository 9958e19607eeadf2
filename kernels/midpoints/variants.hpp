// The variants of the midpoint scan.
#pragma once

#include <vector>

#include "engines/state.hpp"
#include "midpoints/work.hpp"

namespace thinbench::detail {

[[nodiscard]] std::vector<ThinningVariant> midpoint_variants();

/// The state of one compilation of the scan.
[[nodiscard]] std::unique_ptr<ThinningState> make_midpoint_scan(const ScanKernels& kernels,
                                                                const ThinningSetting& setting);

}  // namespace thinbench::detail
