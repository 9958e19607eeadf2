// The word scan on words of 64 pixels in general registers. Compiled without auto-vectorisation, to
// measure the gain of packing alone.
//
// Cost per word: 3 loads, 1 store, 6 shifts and ORs for neighbours, the rule in two-input
// operations (14 for Naccache-Shinghal) and its inversions.
#include "compile/interpreter.hpp"
#include "techniques/word_pass.hpp"

namespace thinbench::detail {

constinit const PassesByRule<std::uint64_t> kScalarPasses =
    passes_by_rule<WordPass<std::uint64_t>>();

constinit const ScanFunction kScalarInterpreter = &interpret<PlaneRows<std::uint64_t>>;

}  // namespace thinbench::detail
