// A bit for each lane of 16 or 32 bits. For ISA files only.
#pragma once

#include "simd/batch.hpp"

namespace thinbench::detail {

using Lanes16 = xsimd::batch<std::uint16_t, Architecture>;
using Lanes32 = xsimd::batch<std::uint32_t, Architecture>;

#if defined(__AVX512BW__)

[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes16 a) {
  return _mm512_test_epi16_mask(a, a);
}
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return _mm512_test_epi32_mask(a, a);
}
/// The highest bit of every lane.
[[gnu::always_inline]] inline std::uint32_t highest_bits(Lanes32 a) {
  return _mm512_movepi32_mask(a);
}
[[gnu::always_inline]] inline std::uint32_t lowest_bits(Lanes32 a) {
  return _mm512_test_epi32_mask(a, _mm512_set1_epi32(1));
}

#elif defined(__AVX2__)

[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes16 a) {
  const __m256i zero = _mm256_setzero_si256();
  // Packing works within 128 bits: eight lanes, eight zeros, eight lanes, eight zeros.
  const __m256i bytes = _mm256_packs_epi16(_mm256_cmpeq_epi16(a, zero), zero);
  const auto equal = static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes));
  return (~equal & 0xFF) | (~equal >> 8 & 0xFF00);
}
[[gnu::always_inline]] inline std::uint32_t highest_bits(Lanes32 a) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(a)));
}
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return ~highest_bits(Lanes32(_mm256_cmpeq_epi32(a, _mm256_setzero_si256()))) & 0xFF;
}
[[gnu::always_inline]] inline std::uint32_t lowest_bits(Lanes32 a) {
  return highest_bits(a << 31);
}

#else

[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes16 a) {
  const __m128i equal = _mm_cmpeq_epi16(a, _mm_setzero_si128());
  return ~static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(equal, equal))) & 0xFF;
}
[[gnu::always_inline]] inline std::uint32_t highest_bits(Lanes32 a) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(a)));
}
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return ~highest_bits(Lanes32(_mm_cmpeq_epi32(a, _mm_setzero_si128()))) & 0xF;
}
[[gnu::always_inline]] inline std::uint32_t lowest_bits(Lanes32 a) {
  return highest_bits(a << 31);
}

#endif

}  // namespace thinbench::detail
