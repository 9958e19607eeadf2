// The vocabulary on AArch64's 128-bit registers (NEON, Advanced SIMD). Compilers themselves make
// BSL of gates and, with FEAT_SHA3, EOR3 and BCAX.
#pragma once

#include <arm_neon.h>

#include "simd/vocabulary.hpp"

// xsimd 8 complements 64-bit lanes as 32-bit lanes; GCC makes BIC and ORN only of lanes of one
// size.
template <>
inline auto xsimd::batch<std::uint64_t, xsimd::neon64>::operator~() const -> batch {
  return ~data;
}

namespace thinbench::detail {

inline namespace THINBENCH_ISA {

inline constexpr bool kHasFunnelShift = true;
inline constexpr bool kHasMaskedBytes = false;
inline constexpr bool kHasCompress = false;
inline constexpr bool kHasByteCompress = false;
inline constexpr bool kHasLanePermute = false;
inline constexpr bool kHasTranspose = false;
inline constexpr bool kHasPopcount = true;
inline constexpr bool kHasByteLookUp = false;
inline constexpr bool kHasBitGather = false;

// SHL or USHR, then SRI or SLI, which shifts and inserts.
template <int count>
inline WordBatch funnel_left(WordBatch a, WordBatch low) {
  return vsriq_n_u64(vshlq_n_u64(a, count), low, 64 - count);
}
template <int count>
inline Lanes32 funnel_left(Lanes32 a, Lanes32 low) {
  return vsriq_n_u32(vshlq_n_u32(a, count), low, 32 - count);
}

template <int count>
inline WordBatch funnel_right(WordBatch a, WordBatch high) {
  return vsliq_n_u64(vshrq_n_u64(a, count), high, 64 - count);
}
template <int count>
inline Lanes32 funnel_right(Lanes32 a, Lanes32 high) {
  return vsliq_n_u32(vshrq_n_u32(a, count), high, 32 - count);
}

/// Byte i is bit i % 8.
[[gnu::always_inline]] inline uint8x16_t bit_of_byte() {
  return vreinterpretq_u8_u64(vdupq_n_u64(0x8040201008040201));
}

/// Bit i is set where byte i is 255; other bytes are 0. Three additions of neighbours gather eight
/// bytes in one.
[[gnu::always_inline]] inline std::uint64_t bits_of_bytes(uint8x16_t bytes) {
  uint8x16_t sums = vandq_u8(bytes, bit_of_byte());
  for (int i = 0; i < 3; ++i) sums = vpaddq_u8(sums, sums);
  return vgetq_lane_u16(vreinterpretq_u16_u8(sums), 0);
}

inline std::uint64_t nonzero_bits(ByteBatch a) {
  return bits_of_bytes(vtstq_u8(a, a));
}

inline ByteBatch nonzero_bytes(ByteBatch a) {
  return vtstq_u8(a, a);
}

inline ByteBatch spread_bits(std::uint64_t bits) {
  const uint8x8_t low = vdup_n_u8(static_cast<std::uint8_t>(bits));
  const uint8x8_t high = vdup_n_u8(static_cast<std::uint8_t>(bits >> 8));
  return vtstq_u8(vcombine_u8(low, high), bit_of_byte());
}

inline std::uint64_t load_16_nonzero_bits(const std::uint8_t* from) {
  return nonzero_bits(vld1q_u8(from));
}

inline void store_16_spread_bits(std::uint8_t* to, std::uint64_t bits) {
  vst1q_u8(to, spread_bits(bits));
}

// NEON has no intrinsic for non-temporal stores.
inline void store_non_temporal(std::uint8_t* to, ByteBatch a) {
  vst1q_u8(to, a);
}

inline void finish_non_temporal_stores() {}

inline std::uint32_t nonzero_lanes(Lanes16 a) {
  constexpr std::uint16_t bit[] = {1, 2, 4, 8, 16, 32, 64, 128};
  return vaddvq_u16(vandq_u16(vtstq_u16(a, a), vld1q_u16(bit)));
}

/// Bit i is set where lane i is all ones; other lanes are 0.
[[gnu::always_inline]] inline std::uint32_t bits_of_lanes(uint32x4_t lanes) {
  constexpr std::uint32_t bit[] = {1, 2, 4, 8};
  return vaddvq_u32(vandq_u32(lanes, vld1q_u32(bit)));
}

inline std::uint32_t nonzero_lanes(Lanes32 a) {
  return bits_of_lanes(vtstq_u32(a, a));
}

inline std::uint32_t highest_bits(Lanes32 a) {
  return bits_of_lanes(vcltzq_s32(vreinterpretq_s32_u32(a)));
}

inline std::uint32_t lowest_bits(Lanes32 a) {
  return bits_of_lanes(vtstq_u32(a, vdupq_n_u32(1)));
}

inline Lanes32 previous_lanes(const std::uint32_t* words, std::uint32_t first) {
  return vextq_u32(vdupq_n_u32(first), vld1q_u32(words), 3);
}

inline Lanes32 next_lanes(const std::uint32_t* words, std::uint32_t last) {
  return vextq_u32(vld1q_u32(words), vdupq_n_u32(last), 1);
}

inline WordBatch previous_in_pair(WordBatch a) {
  return vextq_u64(vdupq_n_u64(0), a, 1);
}

inline WordBatch next_in_pair(WordBatch a) {
  return vextq_u64(a, vdupq_n_u64(0), 1);
}

inline WordBatch popcounts(WordBatch a) {
  return vpaddlq_u32(vpaddlq_u16(vpaddlq_u8(vcntq_u8(vreinterpretq_u8_u64(a)))));
}

inline std::int64_t sum_of_lanes(WordBatch a) {
  return static_cast<std::int64_t>(vaddvq_u64(a));
}

inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return vrhaddq_u8(a, b);
}

inline Halves interleaved(ByteBatch a, ByteBatch b) {
  return {WideBatch(vreinterpretq_s16_u8(vzip1q_u8(a, b))),
          WideBatch(vreinterpretq_s16_u8(vzip2q_u8(a, b)))};
}

// Lower and upper bytes separately; shifts extend the signs of weights.
inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
  const int16x8_t lower = vandq_s16(pairs, vdupq_n_s16(0xFF));
  const int16x8_t upper = vreinterpretq_s16_u16(vshrq_n_u16(vreinterpretq_u16_s16(pairs), 8));
  const int16x8_t lower_weight = vshrq_n_s16(vshlq_n_s16(weights, 8), 8);
  const int16x8_t upper_weight = vshrq_n_s16(weights, 8);
  return vmlaq_s16(vmulq_s16(lower, lower_weight), upper, upper_weight);
}

inline ByteBatch pack(const Halves& a) {
  return vqmovun_high_s16(vqmovun_s16(a.low), a.high);
}

inline ByteBatch first_repeated(ByteBatch a) {
  return vextq_u8(vdupq_laneq_u8(a, 0), a, 15);
}

inline ByteBatch last_repeated(ByteBatch a) {
  return vextq_u8(a, vdupq_laneq_u8(a, 15), 1);
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
