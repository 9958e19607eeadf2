// Arithmetic on grey levels in lanes, beyond what xsimd offers alike in all its versions: a level a
// byte lane, or 16 bits a lane in two halves. For ISA files only.
//
// These types have one name and another meaning at every level, so they stand in an inline
// namespace of the level: the linker would merge whatever a compiler does not inline.
//
// Halves are interleaved as the processor's unpack instructions have it, within 128 bits on AVX2
// and AVX-512. `pack` undoes that; nothing between may depend on the order of lanes.
#pragma once

#include "simd/batch.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

using WideBatch = xsimd::batch<std::int16_t, Architecture>;

struct Halves {
  WideBatch low;
  WideBatch high;

  friend Halves operator+(const Halves& a, const Halves& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend Halves operator-(const Halves& a, const Halves& b) {
    return {a.low - b.low, a.high - b.high};
  }
};

[[gnu::always_inline]] inline Halves absolute(const Halves& a) {
  return {xsimd::abs(a.low), xsimd::abs(a.high)};
}

[[gnu::always_inline]] inline Halves largest(const Halves& a, const Halves& b) {
  return {xsimd::max(a.low, b.low), xsimd::max(a.high, b.high)};
}

/// a - b for values from 0 to 32767; `pack` makes 0 of what is negative.
[[gnu::always_inline]] inline Halves excess(const Halves& a, WideBatch b) {
  return {xsimd::ssub(a.low, b), xsimd::ssub(a.high, b)};
}

[[gnu::always_inline]] inline ByteBatch excess(ByteBatch a, ByteBatch b) {
  return xsimd::ssub(a, b);
}

/// |a - b|.
[[gnu::always_inline]] inline ByteBatch distance(ByteBatch a, ByteBatch b) {
  return xsimd::ssub(a, b) | xsimd::ssub(b, a);
}

#if defined(__AVX512BW__)
[[gnu::always_inline]] inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return _mm512_avg_epu8(a, b);
}
[[gnu::always_inline]] inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {_mm512_unpacklo_epi8(a, b), _mm512_unpackhi_epi8(a, b)};
}
[[gnu::always_inline]] inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
  return _mm512_maddubs_epi16(pairs, weights);
}
[[gnu::always_inline]] inline ByteBatch pack(const Halves& a) {
  return _mm512_packus_epi16(a.low, a.high);
}
[[gnu::always_inline]] inline ByteBatch first_repeated(ByteBatch a) {
  const __m512i first = _mm512_broadcastb_epi8(_mm512_castsi512_si128(a));
  return _mm512_alignr_epi8(a, _mm512_alignr_epi64(a, first, 6), 15);
}
[[gnu::always_inline]] inline ByteBatch last_repeated(ByteBatch a) {
  const __m128i top = _mm512_extracti32x4_epi32(a, 3);
  const __m512i last = _mm512_broadcastb_epi8(_mm_srli_si128(top, 15));
  return _mm512_alignr_epi8(_mm512_alignr_epi64(last, a, 2), a, 1);
}
/// Bit i is set where lane i is not 0.
[[gnu::always_inline]] inline std::uint64_t nonzero_bits(ByteBatch a) {
  return _mm512_test_epi8_mask(a, a);
}
[[gnu::always_inline]] inline ByteBatch nonzero_bytes(ByteBatch a) {
  return _mm512_movm_epi8(_mm512_test_epi8_mask(a, a));
}
#elif defined(__AVX2__)
[[gnu::always_inline]] inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return _mm256_avg_epu8(a, b);
}
[[gnu::always_inline]] inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {_mm256_unpacklo_epi8(a, b), _mm256_unpackhi_epi8(a, b)};
}
[[gnu::always_inline]] inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
  return _mm256_maddubs_epi16(pairs, weights);
}
[[gnu::always_inline]] inline ByteBatch pack(const Halves& a) {
  return _mm256_packus_epi16(a.low, a.high);
}
[[gnu::always_inline]] inline ByteBatch first_repeated(ByteBatch a) {
  const __m256i first = _mm256_broadcastb_epi8(_mm256_castsi256_si128(a));
  return _mm256_alignr_epi8(a, _mm256_permute2x128_si256(a, first, 0x02), 15);
}
[[gnu::always_inline]] inline ByteBatch last_repeated(ByteBatch a) {
  const __m128i top = _mm256_extracti128_si256(a, 1);
  const __m256i last = _mm256_broadcastb_epi8(_mm_srli_si128(top, 15));
  return _mm256_alignr_epi8(_mm256_permute2x128_si256(a, last, 0x21), a, 1);
}
[[gnu::always_inline]] inline std::uint64_t nonzero_bits(ByteBatch a) {
  const __m256i zero = _mm256_cmpeq_epi8(a, _mm256_setzero_si256());
  return ~static_cast<std::uint32_t>(_mm256_movemask_epi8(zero));
}
[[gnu::always_inline]] inline ByteBatch nonzero_bytes(ByteBatch a) {
  const __m256i zero = _mm256_cmpeq_epi8(a, _mm256_setzero_si256());
  return _mm256_xor_si256(zero, _mm256_set1_epi8(-1));
}
#else
[[gnu::always_inline]] inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return _mm_avg_epu8(a, b);
}
[[gnu::always_inline]] inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {_mm_unpacklo_epi8(a, b), _mm_unpackhi_epi8(a, b)};
}
[[gnu::always_inline]] inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
#if defined(__SSSE3__)
  return _mm_maddubs_epi16(pairs, weights);
#else
  // One weight for all lower bytes, one for all upper ones.
  const __m128i lower = _mm_and_si128(pairs, _mm_set1_epi16(0xFF));
  const __m128i upper = _mm_srli_epi16(pairs, 8);
  const __m128i lower_weight = _mm_srai_epi16(_mm_slli_epi16(weights, 8), 8);
  const __m128i upper_weight = _mm_srai_epi16(weights, 8);
  return _mm_add_epi16(_mm_mullo_epi16(lower, lower_weight), _mm_mullo_epi16(upper, upper_weight));
#endif
}
[[gnu::always_inline]] inline ByteBatch pack(const Halves& a) {
  return _mm_packus_epi16(a.low, a.high);
}
[[gnu::always_inline]] inline ByteBatch first_repeated(ByteBatch a) {
  return _mm_or_si128(_mm_slli_si128(a, 1), _mm_and_si128(a, _mm_cvtsi32_si128(0xFF)));
}
[[gnu::always_inline]] inline ByteBatch last_repeated(ByteBatch a) {
  const __m128i last = _mm_slli_si128(_mm_srli_si128(a, 15), 15);
  return _mm_or_si128(_mm_srli_si128(a, 1), last);
}
[[gnu::always_inline]] inline std::uint64_t nonzero_bits(ByteBatch a) {
  return static_cast<std::uint16_t>(~_mm_movemask_epi8(_mm_cmpeq_epi8(a, _mm_setzero_si128())));
}
[[gnu::always_inline]] inline ByteBatch nonzero_bytes(ByteBatch a) {
  return _mm_xor_si128(_mm_cmpeq_epi8(a, _mm_setzero_si128()), _mm_set1_epi8(-1));
}
#endif

/// a + b.
[[gnu::always_inline]] inline Halves sum(ByteBatch a, ByteBatch b) {
  const Halves pairs = interleaved(a, b);
  const WideBatch weights(0x0101);
  return {weighted_pairs(pairs.low, weights), weighted_pairs(pairs.high, weights)};
}

/// a - b.
[[gnu::always_inline]] inline Halves difference(ByteBatch a, ByteBatch b) {
  const Halves pairs = interleaved(a, b);
  const WideBatch weights(static_cast<std::int16_t>(0xFF01));  // -1 in the upper byte
  return {weighted_pairs(pairs.low, weights), weighted_pairs(pairs.high, weights)};
}

[[gnu::always_inline]] inline Halves widened(ByteBatch a) {
  return interleaved(a, ByteBatch(std::uint8_t{0}));
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
