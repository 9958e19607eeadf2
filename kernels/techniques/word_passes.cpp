// The word scan of built-in rules on vectors. Compiled per ISA.
//
// simd_bitpacked: 64 pixels per lane. Cost per register: 3 loads, 1 store, 6 operations for
// neighbours (2 with funnel shifts), the rule's gates, 1 gate to detect changes. Each operation
// computes 8 times as many pixels as in simd_bytes.
//
// simd_bytes: one pixel per byte lane. Cost per register: 3 loads (2 of them unaligned, for
// neighbours), 1 store, the rule's gates.
#include "core/exported.hpp"
#include "simd/vector.hpp"
#include "techniques/word_pass.hpp"

namespace thinbench::detail {

template <>
constinit const SimdPasses Exported<SimdPasses, kThisIsa>::kKernels = {
    passes_by_rule<WordPass<ByteBatch>>(), passes_by_rule<WordPass<WordBatch>>()};

}  // namespace thinbench::detail
