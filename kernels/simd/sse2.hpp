// The vocabulary on 128-bit registers: SSE2, and SSSE3 where the ISA has it.
#pragma once

#include <immintrin.h>

#include "simd/vocabulary.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr bool kHasFunnelShift = false;
inline constexpr bool kHasMaskedBytes = false;
inline constexpr bool kHasCompress = false;
inline constexpr bool kHasByteCompress = false;
inline constexpr bool kHasLanePermute = false;
inline constexpr bool kHasTranspose = false;
inline constexpr bool kHasPopcount = false;
inline constexpr bool kHasByteLookUp = false;  // SSSE3 has it, but one popcnt per word is as fast
inline constexpr bool kHasBitGather = false;

inline std::uint64_t nonzero_bits(ByteBatch a) {
  return static_cast<std::uint16_t>(~_mm_movemask_epi8(_mm_cmpeq_epi8(a, _mm_setzero_si128())));
}

inline ByteBatch nonzero_bytes(ByteBatch a) {
  return _mm_xor_si128(_mm_cmpeq_epi8(a, _mm_setzero_si128()), _mm_set1_epi8(-1));
}

// Byte i tests bit i % 8 of source byte i / 8; the two source bytes are doubled by unpacking.
inline ByteBatch spread_bits(std::uint64_t bits) {
  const __m128i bit = _mm_set1_epi64x(static_cast<long long>(0x8040201008040201));
  const __m128i word = _mm_cvtsi32_si128(static_cast<int>(bits));
  const __m128i pairs = _mm_unpacklo_epi8(word, word);
  const __m128i fours = _mm_unpacklo_epi16(pairs, pairs);
  const __m128i all = _mm_unpacklo_epi32(fours, fours);
  return _mm_cmpeq_epi8(_mm_and_si128(all, bit), bit);
}

inline std::uint64_t load_16_nonzero_bits(const std::uint8_t* from) {
  return nonzero_bits(ByteBatch::load_unaligned(from));
}

inline void store_16_spread_bits(std::uint8_t* to, std::uint64_t bits) {
  spread_bits(bits).store_unaligned(to);
}

inline void store_non_temporal(std::uint8_t* to, ByteBatch a) {
  _mm_stream_si128(reinterpret_cast<__m128i*>(to), a);
}

inline void finish_non_temporal_stores() {
  _mm_sfence();
}

inline std::uint32_t nonzero_lanes(Lanes16 a) {
  const __m128i equal = _mm_cmpeq_epi16(a, _mm_setzero_si128());
  return ~static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(equal, equal))) & 0xFF;
}

inline std::uint32_t highest_bits(Lanes32 a) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(a)));
}

inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return ~highest_bits(Lanes32(_mm_cmpeq_epi32(a, _mm_setzero_si128()))) & 0xF;
}

inline std::uint32_t lowest_bits(Lanes32 a) {
  return highest_bits(a << 31);
}

inline Lanes32 previous_lanes(const std::uint32_t* words, std::uint32_t first) {
  const __m128i lanes = Lanes32::load_unaligned(words - 1);
  const __m128i lane = _mm_cvtsi32_si128(static_cast<int>(first));
  return _mm_castps_si128(_mm_move_ss(_mm_castsi128_ps(lanes), _mm_castsi128_ps(lane)));
}

inline Lanes32 next_lanes(const std::uint32_t* words, std::uint32_t last) {
  const __m128i lanes = _mm_srli_si128(Lanes32::load_aligned(words), 4);
  return _mm_or_si128(lanes, _mm_slli_si128(_mm_cvtsi32_si128(static_cast<int>(last)), 12));
}

inline WordBatch previous_in_pair(WordBatch a) {
  return _mm_bslli_si128(a, 8);
}

inline WordBatch next_in_pair(WordBatch a) {
  return _mm_bsrli_si128(a, 8);
}

inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return _mm_avg_epu8(a, b);
}

inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {_mm_unpacklo_epi8(a, b), _mm_unpackhi_epi8(a, b)};
}

inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
#if defined(__SSSE3__)
  return _mm_maddubs_epi16(pairs, weights);
#else
  // Lower and upper bytes separately; weights are sign-extended by shifts.
  const __m128i lower = _mm_and_si128(pairs, _mm_set1_epi16(0xFF));
  const __m128i upper = _mm_srli_epi16(pairs, 8);
  const __m128i lower_weight = _mm_srai_epi16(_mm_slli_epi16(weights, 8), 8);
  const __m128i upper_weight = _mm_srai_epi16(weights, 8);
  return _mm_add_epi16(_mm_mullo_epi16(lower, lower_weight), _mm_mullo_epi16(upper, upper_weight));
#endif
}

inline ByteBatch pack(const Halves& a) {
  return _mm_packus_epi16(a.low, a.high);
}

inline ByteBatch first_repeated(ByteBatch a) {
  return _mm_or_si128(_mm_slli_si128(a, 1), _mm_and_si128(a, _mm_cvtsi32_si128(0xFF)));
}

inline ByteBatch last_repeated(ByteBatch a) {
  const __m128i last = _mm_slli_si128(_mm_srli_si128(a, 15), 15);
  return _mm_or_si128(_mm_srli_si128(a, 1), last);
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
