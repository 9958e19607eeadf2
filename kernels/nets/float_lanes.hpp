// Single precision across lanes, one pixel each: what the nets need beyond xsimd's arithmetic. For
// ISA files only.
#pragma once

#include "nets/exponential.hpp"
#include "simd/batch.hpp"

namespace thinbench::detail {

using FloatBatch = xsimd::batch<float, Architecture>;
using FloatBool = xsimd::batch_bool<float, Architecture>;
using IntBatch = xsimd::batch<std::int32_t, Architecture>;
inline constexpr Index kFloatLanes = static_cast<Index>(FloatBatch::size);

template <>
struct RealOps<FloatBatch> {
  [[gnu::always_inline]] static FloatBatch constant(float value) { return FloatBatch(value); }
  [[gnu::always_inline]] static FloatBatch clamped(FloatBatch x, float low, float high) {
    return xsimd::min(xsimd::max(x, FloatBatch(low)), FloatBatch(high));
  }
  [[gnu::always_inline]] static FloatBatch rounded(FloatBatch x) {
    const FloatBatch magic(12582912.0F);
    return (x + magic) - magic;
  }
  [[gnu::always_inline]] static FloatBatch power_of_two(FloatBatch n) {
    const IntBatch bits = (xsimd::to_int(n) + IntBatch(127)) << 23;
#if defined(__AVX512F__)
    return _mm512_castsi512_ps(bits);
#elif defined(__AVX2__)
    return _mm256_castsi256_ps(bits);
#else
    return _mm_castsi128_ps(bits);
#endif
  }
};

/// Lanes chosen by the low bits of a word: a mask register on AVX-512, all-ones lanes elsewhere.
#if defined(__AVX512F__)
using LaneMask = __mmask16;
[[gnu::always_inline]] inline LaneMask lane_mask(std::uint64_t bits) {
  return static_cast<LaneMask>(bits);
}
#elif defined(__AVX2__)
using LaneMask = __m256i;
[[gnu::always_inline]] inline LaneMask lane_mask(std::uint64_t bits) {
  const __m256i lane_bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i all = _mm256_set1_epi32(static_cast<int>(bits));
  return _mm256_cmpeq_epi32(_mm256_and_si256(all, lane_bit), lane_bit);
}
#else
using LaneMask = __m128i;
[[gnu::always_inline]] inline LaneMask lane_mask(std::uint64_t bits) {
  const __m128i lane_bit = _mm_setr_epi32(1, 2, 4, 8);
  const __m128i all = _mm_set1_epi32(static_cast<int>(bits));
  return _mm_cmpeq_epi32(_mm_and_si128(all, lane_bit), lane_bit);
}
#endif

/// sum + value in the lanes of `mask`, sum elsewhere: sum + value * n for inputs n of 0 and 1.
[[gnu::always_inline]] inline FloatBatch add_where(LaneMask mask, FloatBatch sum,
                                                   FloatBatch value) {
#if defined(__AVX512F__)
  return _mm512_mask_add_ps(sum, mask, sum, value);
#elif defined(__AVX2__)
  return _mm256_add_ps(sum, _mm256_and_ps(_mm256_castsi256_ps(mask), value));
#else
  return _mm_add_ps(sum, _mm_and_ps(_mm_castsi128_ps(mask), value));
#endif
}

/// Bit i is lane i.
[[gnu::always_inline]] inline std::uint64_t bits_of(FloatBool lanes) {
#if defined(__AVX512F__)
  return static_cast<__mmask16>(lanes);
#elif defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_ps(lanes));
#else
  return static_cast<unsigned>(_mm_movemask_ps(lanes));
#endif
}

/// Bytes 0 and 1 as 0.0 and 1.0.
[[gnu::always_inline]] inline FloatBatch load_bytes(const std::uint8_t* from) {
#if defined(__AVX512F__)
  return _mm512_cvtepi32_ps(
      _mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
#elif defined(__AVX2__)
  return _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadu_si64(from)));
#else
  const __m128i zero = _mm_setzero_si128();
  const __m128i words = _mm_unpacklo_epi8(_mm_loadu_si32(from), zero);
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(words, zero));
#endif
}

/// table[index] for indices 0.0 to 15.0, a look-up in registers where there is one.
[[gnu::always_inline]] inline FloatBatch look_up_16(const float* table, FloatBatch index) {
#if defined(__AVX512F__)
  return _mm512_permutexvar_ps(_mm512_cvtps_epi32(index), _mm512_loadu_ps(table));
#elif defined(__AVX2__)
  // The permutation looks at three bits of the index; the fourth picks the half.
  const __m256i i = _mm256_cvtps_epi32(index);
  const __m256 low = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table), i);
  const __m256 high = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table + 8), i);
  return _mm256_blendv_ps(low, high, _mm256_castsi256_ps(_mm256_slli_epi32(i, 28)));
#else
  float indices[4];
  index.store_unaligned(indices);
  const auto entry = [&](int lane) { return table[static_cast<int>(indices[lane])]; };
  return _mm_setr_ps(entry(0), entry(1), entry(2), entry(3));
#endif
}

}  // namespace thinbench::detail
