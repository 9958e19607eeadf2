// The scanning skeleton on xsimd batches, compiled once for every instruction-set level; see
// sweep.hpp. A row of up to 511 pixels is one batch on AVX-512, where every gate is one
// instruction and 9 counter bits twice, with what they are compared with, stay in registers.
#include "dispatch/exported.hpp"
#include "simd/batch.hpp"
#include "midpoints/engine.hpp"

namespace thinbench::detail {

#ifdef __AVX512F__
// Two permutations and a funnel shift (without VBMI2 two shifts and an OR). Through a ring in
// memory a diagonal of the test image took 1.26 times as long.
template <>
struct RegisterTurn<WordBatch> {
  static constexpr bool kAvailable = true;

  [[gnu::always_inline]] static WordBatch apply(WordBatch row, Index pixels) {
    const __m512i lanes = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 6, 7);
    // Only the low three bits of an index count: lane 0 gets lane 8 - n.
    const __m512i here = _mm512_sub_epi64(lanes, _mm512_set1_epi64(pixels / kWordBits));
    const __m512i before = _mm512_sub_epi64(here, _mm512_set1_epi64(1));
    const __m512i up = _mm512_set1_epi64(pixels % kWordBits);
    const __m512i high = _mm512_permutexvar_epi64(here, row);
    const __m512i low = _mm512_permutexvar_epi64(before, row);
#ifdef __AVX512VBMI2__
    return _mm512_shldv_epi64(high, low, up);
#else
    const __m512i down = _mm512_sub_epi64(_mm512_set1_epi64(kWordBits), up);  // 64 gives 0
    return _mm512_or_si512(_mm512_sllv_epi64(high, up), _mm512_srlv_epi64(low, down));
#endif
  }
};
#endif

template <>
constinit const ScanKernels Exported<ScanKernels, kThisIsa>::kKernels =
    ScanEngine<WordBatch, kThisIsa>::kKernels;

}  // namespace thinbench::detail
