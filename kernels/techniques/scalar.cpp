// The word scan on words of 64 pixels in general registers. Compiled without auto-vectorisation, to
// measure the gain of packing alone.
//
// Cost per word: 3 loads, 1 store, 6 shifts and ORs for neighbours, the rule in two-input
// operations (14 for Naccache-Shinghal) and its inversions.
#include "techniques/scalar.hpp"

#include "compile/interpreter.hpp"
#include "scan/window.hpp"

namespace thinbench::detail {

constinit const ByRule<ScanFunctions> kScalarScans =
    scan_functions_by_rule<PlaneRows<std::uint64_t>>();

constinit const ScanFunction kScalarInterpreter = &interpret<PlaneRows<std::uint64_t>>;

}  // namespace thinbench::detail
