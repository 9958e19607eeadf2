// The scanning skeleton on xsimd batches, compiled once for every instruction-set level; see
// sweep.hpp. A row of up to 511 pixels is one batch on AVX-512, where every gate is one
// instruction and 9 counter bits twice, with what they are compared with, stay in registers.
#include <concepts>

#include "dispatch/exported.hpp"
#include "midpoints/engine.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {

// Through a ring in memory a diagonal of the test image took 1.26 times as long.
template <std::same_as<WordBatch> Word>
requires kRegisterHoldsRow struct RegisterTurn<Word> {
  static constexpr bool kAvailable = true;

  [[gnu::always_inline]] static Word apply(Word row, Index pixels) { return rotated(row, pixels); }
};

template <>
constinit const ScanKernels Exported<ScanKernels, kThisIsa>::kKernels =
    ScanEngine<WordBatch, kThisIsa>::kKernels;

}  // namespace thinbench::detail
