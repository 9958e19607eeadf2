// The interpreter on words of 64 pixels in general registers.
#pragma once

#include "thinning/engines/custom_scan.hpp"

namespace thinbench::detail {

/// Executes SlotNetworks of two-input gates, on Layout::words.
extern const ScanFunction kScalarInterpreter;

}  // namespace thinbench::detail
