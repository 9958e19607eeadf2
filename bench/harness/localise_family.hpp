// The chain from a grey picture to objects and holes as the harness sees it: lists as numbers.
#pragma once

#include <vector>

#include "harness/operation.hpp"

namespace thinbench {

/// One operation, with the default thresholds.
[[nodiscard]] std::vector<Operation> localise_family();

}  // namespace thinbench
