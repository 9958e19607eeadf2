// The midpoint scan on vectors (column_scan.hpp). Compiled per ISA. On AVX-512 a row of up to
// 511 pixels is one batch, every gate is one instruction, and both 9-bit counters and the values
// they are compared with stay in registers.
#include <concepts>

#include "core/exported.hpp"
#include "midpoints/engine.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {

// A ring in memory takes 1.26 times as long for a diagonal of the test image.
template <std::same_as<WordBatch> Word>
requires kRegisterHoldsRow struct RegisterRotl<Word, kThisIsa> {
  static constexpr bool kAvailable = true;

  [[gnu::always_inline]] static Word apply(Word row, Index pixels) { return rotated(row, pixels); }
};

template <>
constinit const ScanKernels Exported<ScanKernels, kThisIsa>::kKernels =
    ScanEngine<WordBatch, kThisIsa>::kKernels;

}  // namespace thinbench::detail
