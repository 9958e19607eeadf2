// The interpreter on words of 64 pixels in general registers.
#pragma once

#include "thinning/engines/custom_scan.hpp"

namespace thinbench::detail {

/// Executes SlotPrograms that are not ternary, on Layout::words.
extern const ScanFunction kScalarInterpreter;

}  // namespace thinbench::detail
