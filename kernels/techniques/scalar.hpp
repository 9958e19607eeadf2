// Scan functions of words in general registers, and of byte lanes.
#pragma once

#include "scan/built_in.hpp"

namespace thinbench::detail {

/// Built-in rules on words of 64 pixels. Compiled once, for the baseline.
extern const ByRule<ScanFunctions> kScalarScans;

/// The interpreter on such words. Executes SlotPrograms that are not ternary, on Layout::words.
extern const ScanFunction kScalarInterpreter;

/// Built-in rules on byte lanes. Compiled for every ISA.
struct ByteScans {
  Index register_elements;
  ByRule<ScanFunctions> functions;
};

}  // namespace thinbench::detail
