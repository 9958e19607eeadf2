// The vocabulary on 256-bit registers: AVX2 and BMI2.
#pragma once

#include <immintrin.h>

#include "simd/byte_tables.hpp"
#include "simd/vocabulary.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr bool kHasFunnelShift = false;
inline constexpr bool kHasMaskedBytes = false;
inline constexpr bool kHasCompress = true;
inline constexpr bool kHasByteCompress = false;
inline constexpr bool kHasLanePermute = true;
inline constexpr bool kHasTranspose = false;
inline constexpr bool kHasPopcount = false;
inline constexpr bool kHasByteLookUp = true;
inline constexpr bool kHasBitGather = true;

inline std::uint64_t nonzero_bits(ByteBatch a) {
  const __m256i zero = _mm256_cmpeq_epi8(a, _mm256_setzero_si256());
  return ~static_cast<std::uint32_t>(_mm256_movemask_epi8(zero));
}

inline ByteBatch nonzero_bytes(ByteBatch a) {
  const __m256i zero = _mm256_cmpeq_epi8(a, _mm256_setzero_si256());
  return _mm256_xor_si256(zero, _mm256_set1_epi8(-1));
}

// Byte i tests bit i % 8 of source byte i / 8:
//   lanes  0 1 .. 7 | 8 .. 15 | 16 .. 23 | 24 .. 31
//   byte   0 0 .. 0 | 1 ..  1 |  2 ..  2 |  3 ..  3
inline ByteBatch spread_bits(std::uint64_t bits) {
  const __m256i which =
      _mm256_setr_epi64x(0, 0x0101010101010101, 0x0202020202020202, 0x0303030303030303);
  const __m256i bit = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201));
  const __m256i all = _mm256_set1_epi32(static_cast<int>(bits));
  return _mm256_cmpeq_epi8(_mm256_and_si256(_mm256_shuffle_epi8(all, which), bit), bit);
}

inline std::uint64_t load_16_nonzero_bits(const std::uint8_t* from) {
  const __m128i lanes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
  const auto zero = _mm_movemask_epi8(_mm_cmpeq_epi8(lanes, _mm_setzero_si128()));
  return static_cast<std::uint16_t>(~zero);
}

inline void store_16_spread_bits(std::uint8_t* to, std::uint64_t bits) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm256_castsi256_si128(spread_bits(bits)));
}

inline void store_non_temporal(std::uint8_t* to, ByteBatch a) {
  _mm256_stream_si256(reinterpret_cast<__m256i*>(to), a);
}

inline void finish_non_temporal_stores() {
  _mm_sfence();
}

inline std::uint64_t gather_bits(std::uint64_t word, std::uint64_t mask) {
  return _pext_u64(word, mask);
}

inline std::uint64_t scatter_bits(std::uint64_t word, std::uint64_t mask) {
  return _pdep_u64(word, mask);
}

// Packing works within 128 bits and gives eight lanes, eight zeros, eight lanes, eight zeros.
inline std::uint32_t nonzero_lanes(Lanes16 a) {
  const __m256i zero = _mm256_setzero_si256();
  const __m256i bytes = _mm256_packs_epi16(_mm256_cmpeq_epi16(a, zero), zero);
  const auto equal = static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes));
  return (~equal & 0xFF) | (~equal >> 8 & 0xFF00);
}

inline std::uint32_t highest_bits(Lanes32 a) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(a)));
}

inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return ~highest_bits(Lanes32(_mm256_cmpeq_epi32(a, _mm256_setzero_si256()))) & 0xFF;
}

inline std::uint32_t nonzero_lanes(WordBatch a) {
  const __m256i zero = _mm256_cmpeq_epi64(a, _mm256_setzero_si256());
  return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_castsi256_pd(zero))) ^ 0xF;
}

[[gnu::always_inline]] inline __m256i lanes_of_bytes(const std::array<std::uint8_t, 8>& bytes) {
  return _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(bytes.data())));
}

inline Lanes32 counts_upto(std::uint32_t bits) {
  return lanes_of_bytes(kPrefixCounts[bits & 0xFF]);
}

/// All ones in the lanes whose bits are set.
[[gnu::always_inline]] inline __m256i lanes_of_bits(std::uint32_t bits) {
  const __m256i lane_bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i all = _mm256_set1_epi32(static_cast<int>(bits));
  return _mm256_cmpeq_epi32(_mm256_and_si256(all, lane_bit), lane_bit);
}

inline Lanes32 permuted_where(Lanes32 a, Lanes32 index, std::uint32_t selected) {
  return _mm256_and_si256(_mm256_permutevar8x32_epi32(a, index), lanes_of_bits(selected));
}

inline Lanes32 lane_numbers() {
  return _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
}

inline void store_compressed(std::uint32_t* to, Lanes32 a, std::uint32_t selected) {
  const __m256i index = lanes_of_bytes(kSetBits[selected & 0xFF]);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(a, index));
}

inline void store_first(std::uint32_t* to, Lanes32 a, Index count) {
  _mm256_maskstore_epi32(reinterpret_cast<int*>(to), lanes_of_bits((1U << count) - 1), a);
}

inline std::uint32_t lowest_bits(Lanes32 a) {
  return highest_bits(a << 31);
}

inline Lanes32 previous_lanes(const std::uint32_t* words, std::uint32_t first) {
  const __m256i lane = _mm256_set1_epi32(static_cast<int>(first));
  return _mm256_blend_epi32(Lanes32::load_unaligned(words - 1), lane, 0x01);
}

inline Lanes32 next_lanes(const std::uint32_t* words, std::uint32_t last) {
  const __m256i lane = _mm256_set1_epi32(static_cast<int>(last));
  return _mm256_blend_epi32(Lanes32::load_unaligned(words + 1), lane, 0x80);
}

inline WordBatch previous_in_pair(WordBatch a) {
  return _mm256_bslli_epi128(a, 8);
}

inline WordBatch next_in_pair(WordBatch a) {
  return _mm256_bsrli_epi128(a, 8);
}

inline ByteBatch byte_table(const std::uint8_t* table) {
  return _mm256_broadcastsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(table)));
}

inline ByteBatch look_up(ByteBatch table, ByteBatch index) {
  return _mm256_shuffle_epi8(table, index);
}

inline WordBatch byte_sums(ByteBatch a) {
  return _mm256_sad_epu8(a, _mm256_setzero_si256());
}

inline std::int64_t sum_of_lanes(WordBatch a) {
  const __m128i half = _mm_add_epi64(_mm256_castsi256_si128(a), _mm256_extracti128_si256(a, 1));
  return _mm_cvtsi128_si64(half) + _mm_extract_epi64(half, 1);
}

inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return _mm256_avg_epu8(a, b);
}

inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {_mm256_unpacklo_epi8(a, b), _mm256_unpackhi_epi8(a, b)};
}

inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
  return _mm256_maddubs_epi16(pairs, weights);
}

inline ByteBatch pack(const Halves& a) {
  return _mm256_packus_epi16(a.low, a.high);
}

inline ByteBatch first_repeated(ByteBatch a) {
  const __m256i first = _mm256_broadcastb_epi8(_mm256_castsi256_si128(a));
  return _mm256_alignr_epi8(a, _mm256_permute2x128_si256(a, first, 0x02), 15);
}

inline ByteBatch last_repeated(ByteBatch a) {
  const __m128i top = _mm256_extracti128_si256(a, 1);
  const __m256i last = _mm256_broadcastb_epi8(_mm_srli_si128(top, 15));
  return _mm256_alignr_epi8(_mm256_permute2x128_si256(a, last, 0x21), a, 1);
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
