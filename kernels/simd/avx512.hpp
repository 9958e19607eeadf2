// The vocabulary on 512-bit registers: AVX-512 F, CD, DQ, BW and VL, and VBMI, VBMI2, VPOPCNTDQ and
// GFNI where the ISA has them.
#pragma once

#include <immintrin.h>

#include "simd/byte_tables.hpp"
#include "simd/vocabulary.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

/// vpternlog: every gate with three inputs is one instruction.
template <class T>
struct TernaryGate<xsimd::batch<T, xsimd::avx512bw>> {
  using Word = xsimd::batch<T, xsimd::avx512bw>;
  static constexpr bool kOneInstruction = true;

  template <std::uint8_t truth_table>
  [[gnu::always_inline]] static Word apply(Word a, Word b, Word c) {
    return _mm512_ternarylogic_epi64(a, b, c, truth_table);
  }
};

inline namespace THINBENCH_ISA {

inline constexpr bool kHasMaskedBytes = true;
inline constexpr bool kHasCompress = true;
inline constexpr bool kHasLanePermute = true;
inline constexpr bool kHasTranspose = true;
inline constexpr bool kHasByteLookUp = true;
inline constexpr bool kHasBitGather = true;

#ifdef __AVX512VBMI2__

inline constexpr bool kHasFunnelShift = true;
inline constexpr bool kHasByteCompress = true;

template <int count>
inline WordBatch funnel_left(WordBatch a, WordBatch low) {
  return _mm512_shldi_epi64(a, low, count);
}
template <int count>
inline Lanes32 funnel_left(Lanes32 a, Lanes32 low) {
  return _mm512_shldi_epi32(a, low, count);
}

template <int count>
inline WordBatch funnel_right(WordBatch a, WordBatch high) {
  return _mm512_shrdi_epi64(a, high, count);
}
template <int count>
inline Lanes32 funnel_right(Lanes32 a, Lanes32 high) {
  return _mm512_shrdi_epi32(a, high, count);
}

inline ByteBatch set_bit_places(std::uint64_t bits) {
  const __m512i numbers = _mm512_set_epi8(
      63, 62, 61, 60, 59, 58, 57, 56, 55, 54, 53, 52, 51, 50, 49, 48, 47, 46, 45, 44, 43, 42, 41,
      40, 39, 38, 37, 36, 35, 34, 33, 32, 31, 30, 29, 28, 27, 26, 25, 24, 23, 22, 21, 20, 19, 18,
      17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
  return _mm512_maskz_compress_epi8(bits, numbers);
}

template <int number>
inline IntBatch widened_quarter(ByteBatch a) {
  return _mm512_cvtepu8_epi32(_mm512_extracti32x4_epi32(a, number));
}

#else

inline constexpr bool kHasFunnelShift = false;
inline constexpr bool kHasByteCompress = false;

#endif

#ifdef __AVX512VPOPCNTDQ__

inline constexpr bool kHasPopcount = true;

inline WordBatch popcounts(WordBatch a) {
  return _mm512_popcnt_epi64(a);
}

inline Lanes32 counts_upto(std::uint32_t bits) {
  const __m512i upto = _mm512_setr_epi32(1, 3, 7, 15, 31, 63, 127, 255, 511, 1023, 2047, 4095, 8191,
                                         16383, 32767, 65535);
  return _mm512_popcnt_epi32(_mm512_and_si512(_mm512_set1_epi32(static_cast<int>(bits)), upto));
}

#else

inline constexpr bool kHasPopcount = false;

inline Lanes32 counts_upto(std::uint32_t bits) {
  const auto counts = [](std::uint32_t byte) {
    return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPrefixCounts[byte & 0xFF].data()));
  };
  const __m128i low = counts(bits);
  const __m128i high = _mm_add_epi8(
      counts(bits >> 8), _mm_set1_epi8(static_cast<char>(kPrefixCounts[bits & 0xFF][7])));
  return _mm512_cvtepu8_epi32(_mm_unpacklo_epi64(low, high));
}

#endif

inline std::uint64_t nonzero_bits(ByteBatch a) {
  return _mm512_test_epi8_mask(a, a);
}

inline ByteBatch nonzero_bytes(ByteBatch a) {
  return _mm512_movm_epi8(_mm512_test_epi8_mask(a, a));
}

inline ByteBatch spread_bits(std::uint64_t bits) {
  return _mm512_movm_epi8(bits);
}

template <class Bits>
inline Bits load_nonzero_bits(const std::uint8_t* from, Bits mask) {
  if constexpr (sizeof(Bits) == 4) {
    const __m256i lanes = _mm256_maskz_loadu_epi8(mask, from);
    return _mm256_test_epi8_mask(lanes, lanes);
  } else {
    const __m512i lanes = _mm512_maskz_loadu_epi8(mask, from);
    return _mm512_test_epi8_mask(lanes, lanes);
  }
}

template <class Bits>
inline void store_spread_bits(std::uint8_t* to, Bits bits, Bits mask) {
  if constexpr (sizeof(Bits) == 4) {
    _mm256_mask_storeu_epi8(to, mask, _mm256_movm_epi8(bits));
  } else {
    _mm512_mask_storeu_epi8(to, mask, _mm512_movm_epi8(bits));
  }
}

inline void store_non_temporal(std::uint8_t* to, ByteBatch a) {
  _mm512_stream_si512(reinterpret_cast<__m512i*>(to), a);
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

inline std::uint32_t nonzero_lanes(Lanes16 a) {
  return _mm512_test_epi16_mask(a, a);
}

inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return _mm512_test_epi32_mask(a, a);
}

inline std::uint32_t nonzero_lanes(WordBatch a) {
  return _mm512_test_epi64_mask(a, a);
}

inline Lanes32 permuted_where(Lanes32 a, Lanes32 index, std::uint32_t selected) {
  return _mm512_maskz_permutexvar_epi32(static_cast<__mmask16>(selected), index, a);
}

inline void store_first(std::uint32_t* to, Lanes32 a, Index count) {
  _mm512_mask_storeu_epi32(to, static_cast<__mmask16>((1U << count) - 1), a);
}

inline std::uint32_t highest_bits(Lanes32 a) {
  return _mm512_movepi32_mask(a);
}

inline std::uint32_t lowest_bits(Lanes32 a) {
  return _mm512_test_epi32_mask(a, _mm512_set1_epi32(1));
}

inline Lanes32 previous_lanes(const std::uint32_t* words, std::uint32_t first) {
  const __m512i lane = _mm512_set1_epi32(static_cast<int>(first));
  return _mm512_alignr_epi32(Lanes32::load_aligned(words), lane, 15);
}

inline Lanes32 next_lanes(const std::uint32_t* words, std::uint32_t last) {
  const __m512i lane = _mm512_set1_epi32(static_cast<int>(last));
  return _mm512_alignr_epi32(lane, Lanes32::load_aligned(words), 1);
}

// Joined in mask registers: through general registers a visit of a tile takes 9 cycles longer.
inline void store_lane_bits(std::uint64_t* to, Lanes32 a, Lanes32 b, Lanes32 c) {
  const __mmask32 low = _mm512_kunpackw(_mm512_test_epi32_mask(b, b), _mm512_test_epi32_mask(a, a));
  const __mmask32 high =
      _mm512_kunpackw(_mm512_movepi32_mask(c), _mm512_test_epi32_mask(c, _mm512_set1_epi32(1)));
  _store_mask64(reinterpret_cast<__mmask64*>(to), _mm512_kunpackd(high, low));
}

inline WordQuarters quarters_of_words(const std::uint64_t* words) {
  const auto load = [&](int number) { return _mm512_loadu_si512(words + 8 * number); };
  // Of 16 words: their first quarters, then their second ones; third and fourth ones.
  const __m512i low = _mm512_set_epi16(61, 57, 53, 49, 45, 41, 37, 33, 29, 25, 21, 17, 13, 9, 5, 1,
                                       60, 56, 52, 48, 44, 40, 36, 32, 28, 24, 20, 16, 12, 8, 4, 0);
  const __m512i high = _mm512_add_epi16(low, _mm512_set1_epi16(2));
  const auto halves = [&](__m512i index, int number) {
    return _mm512_permutex2var_epi16(load(number), index, load(number + 1));
  };
  const __m512i low_0 = halves(low, 0);
  const __m512i low_1 = halves(low, 2);
  const __m512i high_0 = halves(high, 0);
  const __m512i high_1 = halves(high, 2);
  const auto joined = [](__m512i a, __m512i b) {
    return _mm512_inserti64x4(a, _mm512_castsi512_si256(b), 1);
  };
  constexpr int upper = 0xEE;  // 128-bit parts 2 and 3 of each operand
  return {joined(low_0, low_1), _mm512_shuffle_i64x2(low_0, low_1, upper), joined(high_0, high_1),
          _mm512_shuffle_i64x2(high_0, high_1, upper)};
}

inline WordBatch previous_in_pair(WordBatch a) {
  return _mm512_bslli_epi128(a, 8);
}

inline WordBatch next_in_pair(WordBatch a) {
  return _mm512_bsrli_epi128(a, 8);
}

inline WordBatch previous_word(WordBatch a) {
  return _mm512_alignr_epi64(a, _mm512_setzero_si512(), 7);
}

inline WordBatch next_word(WordBatch a) {
  return _mm512_alignr_epi64(_mm512_setzero_si512(), a, 1);
}

inline WordBatch previous_word(WordBatch a, WordBatch before) {
  return _mm512_alignr_epi64(a, before, 7);
}

// A lane passes a carry on if it is all ones, and a carry through these lanes is one of the
// addition of their masks.
inline WordBatch sum_with_carry(WordBatch a, WordBatch b, std::uint64_t& carry) {
  const __m512i ones = _mm512_set1_epi64(-1);
  const __m512i sum = _mm512_add_epi64(a, b);
  const std::uint64_t carries = _mm512_cmplt_epu64_mask(sum, a);
  const std::uint64_t passing = _mm512_cmpeq_epi64_mask(sum, ones);
  const std::uint64_t entering = ((carries << 1 | carry) + passing) ^ passing;
  carry = entering >> 8;
  return _mm512_mask_sub_epi64(sum, static_cast<__mmask8>(entering), sum, ones);
}

#ifdef __GFNI__

inline WordBatch reversed(WordBatch row) {
  const __m512i backwards = _mm512_set_epi8(
      0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25,
      26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48,
      49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63);
  const __m512i mirror = _mm512_set1_epi64(static_cast<long long>(0x8040201008040201));
  return _mm512_gf2p8affine_epi64_epi8(_mm512_permutexvar_epi8(backwards, row), mirror, 0);
}

#else

// Halves of bytes are looked up reversed; bytes are reversed within 128 bits, then these.
inline WordBatch reversed(WordBatch row) {
  const __m512i low_halves = _mm512_set1_epi8(0x0F);
  const auto for_all = [](__m128i table) { return _mm512_broadcast_i32x4(table); };
  const __m512i of_low = for_all(_mm_setr_epi8(0x00, -0x80, 0x40, -0x40, 0x20, -0x60, 0x60, -0x20,
                                               0x10, -0x70, 0x50, -0x30, 0x30, -0x50, 0x70, -0x10));
  const __m512i of_high = for_all(_mm_setr_epi8(0x0, 0x8, 0x4, 0xC, 0x2, 0xA, 0x6, 0xE, 0x1, 0x9,
                                                0x5, 0xD, 0x3, 0xB, 0x7, 0xF));
  const __m512i backwards =
      for_all(_mm_setr_epi8(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0));
  const __m512i low = _mm512_and_si512(row, low_halves);
  const __m512i high = _mm512_and_si512(_mm512_srli_epi16(row, 4), low_halves);
  const __m512i bytes =
      _mm512_or_si512(_mm512_shuffle_epi8(of_low, low), _mm512_shuffle_epi8(of_high, high));
  const __m512i quarters = _mm512_shuffle_epi8(bytes, backwards);
  return _mm512_shuffle_i64x2(quarters, quarters, _MM_SHUFFLE(0, 1, 2, 3));
}

#endif

inline WordBatch sums_before(WordBatch a) {
  const __m512i zero = _mm512_setzero_si512();
  __m512i sums = _mm512_alignr_epi64(a, zero, 7);
  sums = _mm512_add_epi64(sums, _mm512_alignr_epi64(sums, zero, 7));
  sums = _mm512_add_epi64(sums, _mm512_alignr_epi64(sums, zero, 6));
  return _mm512_add_epi64(sums, _mm512_alignr_epi64(sums, zero, 4));
}

template <class Block>
inline Block lowest_word(std::uint64_t word) {
  return _mm512_maskz_set1_epi64(1, static_cast<long long>(word));
}

// Two permutations, which use the low three bits of an index, so that lane -1 is lane 7; and a
// funnel shift, without VBMI2 two shifts and an OR.
inline WordBatch rotated(WordBatch row, Index pixels) {
  const __m512i lanes = _mm512_setr_epi64(0, 1, 2, 3, 4, 5, 6, 7);
  const __m512i here = _mm512_sub_epi64(lanes, _mm512_set1_epi64(pixels / 64));
  const __m512i before = _mm512_sub_epi64(here, _mm512_set1_epi64(1));
  const __m512i up = _mm512_set1_epi64(pixels % 64);
  const __m512i high = _mm512_permutexvar_epi64(here, row);
  const __m512i low = _mm512_permutexvar_epi64(before, row);
#ifdef __AVX512VBMI2__
  return _mm512_shldv_epi64(high, low, up);
#else
  const __m512i down = _mm512_sub_epi64(_mm512_set1_epi64(64), up);  // 64 gives 0
  return _mm512_or_si512(_mm512_sllv_epi64(high, up), _mm512_srlv_epi64(low, down));
#endif
}

/// rows[4 i + j]: lanes j, j + 4, j + 8, j + 12 of the rows 4 i to 4 i + 3.
[[gnu::always_inline]] inline Square interleaved_fours(const Square& in) {
  Square pairs;
  for (int i = 0; i < 16; i += 2) {
    pairs.rows[i] = _mm512_unpacklo_epi32(in.rows[i], in.rows[i + 1]);
    pairs.rows[i + 1] = _mm512_unpackhi_epi32(in.rows[i], in.rows[i + 1]);
  }
  Square fours;
  for (int i = 0; i < 16; i += 4) {
    fours.rows[i] = _mm512_unpacklo_epi64(pairs.rows[i], pairs.rows[i + 2]);
    fours.rows[i + 1] = _mm512_unpackhi_epi64(pairs.rows[i], pairs.rows[i + 2]);
    fours.rows[i + 2] = _mm512_unpacklo_epi64(pairs.rows[i + 1], pairs.rows[i + 3]);
    fours.rows[i + 3] = _mm512_unpackhi_epi64(pairs.rows[i + 1], pairs.rows[i + 3]);
  }
  return fours;
}

inline Square transposed(const Square& in) {
  constexpr int even = 0x88;  // 128-bit parts 0 and 2 of each operand
  constexpr int odd = 0xDD;
  const Square fours = interleaved_fours(in);
  Square out;
  for (int j = 0; j < 4; ++j) {
    const __m512i a = fours.rows[j];
    const __m512i b = fours.rows[j + 4];
    const __m512i c = fours.rows[j + 8];
    const __m512i d = fours.rows[j + 12];
    const __m512i even_ab = _mm512_shuffle_i32x4(a, b, even);
    const __m512i even_cd = _mm512_shuffle_i32x4(c, d, even);
    const __m512i odd_ab = _mm512_shuffle_i32x4(a, b, odd);
    const __m512i odd_cd = _mm512_shuffle_i32x4(c, d, odd);
    out.rows[j] = _mm512_shuffle_i32x4(even_ab, even_cd, even);
    out.rows[j + 4] = _mm512_shuffle_i32x4(odd_ab, odd_cd, even);
    out.rows[j + 8] = _mm512_shuffle_i32x4(even_ab, even_cd, odd);
    out.rows[j + 12] = _mm512_shuffle_i32x4(odd_ab, odd_cd, odd);
  }
  return out;
}

inline Lanes32 lane_numbers() {
  return _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}

inline void store_compressed(std::uint32_t* to, Lanes32 a, std::uint32_t selected) {
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(selected), a));
}

inline ByteBatch byte_table(const std::uint8_t* table) {
  return _mm512_broadcast_i32x4(_mm_loadu_si128(reinterpret_cast<const __m128i*>(table)));
}

inline ByteBatch look_up(ByteBatch table, ByteBatch index) {
  return _mm512_shuffle_epi8(table, index);
}

inline WordBatch byte_sums(ByteBatch a) {
  return _mm512_sad_epu8(a, _mm512_setzero_si512());
}

inline std::int64_t sum_of_lanes(WordBatch a) {
  return _mm512_reduce_add_epi64(a);
}

inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return _mm512_avg_epu8(a, b);
}

inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {_mm512_unpacklo_epi8(a, b), _mm512_unpackhi_epi8(a, b)};
}

inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
  return _mm512_maddubs_epi16(pairs, weights);
}

inline ByteBatch pack(const Halves& a) {
  return _mm512_packus_epi16(a.low, a.high);
}

inline ByteBatch first_repeated(ByteBatch a) {
  const __m512i first = _mm512_broadcastb_epi8(_mm512_castsi512_si128(a));
  return _mm512_alignr_epi8(a, _mm512_alignr_epi64(a, first, 6), 15);
}

inline ByteBatch last_repeated(ByteBatch a) {
  const __m128i top = _mm512_extracti32x4_epi32(a, 3);
  const __m512i last = _mm512_broadcastb_epi8(_mm_srli_si128(top, 15));
  return _mm512_alignr_epi8(_mm512_alignr_epi64(last, a, 2), a, 1);
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
