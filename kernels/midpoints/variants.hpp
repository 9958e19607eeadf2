// The variants of the midpoint scan.
#pragma once

#include <vector>

#include "thinning/state.hpp"

namespace thinbench::detail {

[[nodiscard]] std::vector<ThinningVariant> midpoint_variants();

}  // namespace thinbench::detail
