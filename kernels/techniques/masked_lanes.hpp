// Masked arithmetic on lanes, for nets: the vocabulary of simd/ that no other kernel needs. For ISA
// files only.
#pragma once

#include "simd/vector.hpp"

#if defined(__aarch64__) && !defined(THINBENCH_NO_SIMD)
// xsimd 8 divides by an estimate of the reciprocal, which is not exact.
template <>
inline auto xsimd::batch<float, xsimd::neon64>::operator/=(const batch& divisor) noexcept
    -> batch& {
  data = vdivq_f32(data, divisor.data);
  return *this;
}
#endif

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

using SignedByteBatch = BatchOf<std::int8_t>;
using FloatBatch = BatchOf<float>;

/// Masks of lanes: a mask register where the ISA has them, else lanes of all ones.
using LaneMask = simd::batch_bool<float, Architecture>;
using ByteMask = simd::batch_bool<std::uint8_t, Architecture>;

/// Bit i is set where the lane that `pack` narrows to byte i is not negative.
[[gnu::always_inline]] inline std::uint64_t nonnegative_bits(const Halves& a);

/// Selects byte i where bit i is set; bits beyond the lanes are ignored.
[[gnu::always_inline]] inline ByteMask byte_mask(std::uint64_t bits);

/// sum + value in the lanes of `mask`, sum elsewhere: sum + value * n for inputs n of 0 and 1.
[[gnu::always_inline]] inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum,
                                                        SignedByteBatch value);
[[gnu::always_inline]] inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value);

/// Selects lane i where bit i is set; bits beyond the lanes are ignored.
[[gnu::always_inline]] inline LaneMask lane_mask(std::uint64_t bits);

/// Bit i is set where lane i is selected.
[[gnu::always_inline]] inline std::uint64_t bits_of(LaneMask lanes);

/// table[index] for indices 0.0 to 15.0.
[[gnu::always_inline]] inline FloatBatch look_up_16(const float* table, FloatBatch index);

#if defined(THINBENCH_NO_SIMD)

inline std::uint64_t nonnegative_bits(const Halves& a) {
  return nonzero_bits(narrowed<ByteBatch>(a, [](int lane) { return lane >= 0; }));
}

inline ByteMask byte_mask(std::uint64_t bits) {
  return spread_bits(bits) != ByteBatch(std::uint8_t{0});
}

inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum, SignedByteBatch value) {
  const ByteMask::register_type lanes = mask;
  return SignedByteBatch::lanes(
      [&](std::size_t i) { return lanes[i] ? sum[i] + value[i] : sum[i]; });
}

inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value) {
  return sum + simd::select(mask, value, FloatBatch(0.0F));
}

inline LaneMask lane_mask(std::uint64_t bits) {
  const FloatBatch zero(0.0F);
  return FloatBatch::lanes([&](std::size_t i) { return bits >> i & 1; }) != zero;
}

inline std::uint64_t bits_of(LaneMask mask) {
  const LaneMask::register_type lanes = mask;
  return bits_where(lanes.size(), [&](std::size_t i) { return lanes[i]; });
}

inline FloatBatch look_up_16(const float* table, FloatBatch index) {
  return FloatBatch::lanes([&](std::size_t i) { return table[static_cast<int>(index[i])]; });
}

#elif defined(__AVX512BW__)

// Saturation preserves signs.
inline std::uint64_t nonnegative_bits(const Halves& a) {
  return ~_mm512_movepi8_mask(_mm512_packs_epi16(a.low, a.high));
}

inline ByteMask byte_mask(std::uint64_t bits) {
  return static_cast<__mmask64>(bits);
}

inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum, SignedByteBatch value) {
  return _mm512_mask_add_epi8(sum, mask, sum, value);
}

inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value) {
  return _mm512_mask_add_ps(sum, mask, sum, value);
}

inline LaneMask lane_mask(std::uint64_t bits) {
  return static_cast<__mmask16>(bits);
}

inline std::uint64_t bits_of(LaneMask lanes) {
  return static_cast<__mmask16>(lanes);
}

inline FloatBatch look_up_16(const float* table, FloatBatch index) {
  return _mm512_permutexvar_ps(_mm512_cvtps_epi32(index), _mm512_loadu_ps(table));
}

#elif defined(__AVX2__)

// Saturation preserves signs.
inline std::uint64_t nonnegative_bits(const Halves& a) {
  return ~static_cast<std::uint32_t>(_mm256_movemask_epi8(_mm256_packs_epi16(a.low, a.high)));
}

inline ByteMask byte_mask(std::uint64_t bits) {
  const __m256i lanes = spread_bits(bits);
  return lanes;
}

inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum, SignedByteBatch value) {
  return _mm256_add_epi8(sum, _mm256_and_si256(mask, value));
}

inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value) {
  return _mm256_add_ps(sum, _mm256_and_ps(mask, value));
}

inline LaneMask lane_mask(std::uint64_t bits) {
  return _mm256_castsi256_ps(lanes_of_bits(static_cast<std::uint32_t>(bits)));
}

inline std::uint64_t bits_of(LaneMask lanes) {
  return static_cast<unsigned>(_mm256_movemask_ps(lanes));
}

// The permutation uses three bits of the index; the fourth selects the half.
inline FloatBatch look_up_16(const float* table, FloatBatch index) {
  const __m256i i = _mm256_cvtps_epi32(index);
  const __m256 low = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table), i);
  const __m256 high = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table + 8), i);
  return _mm256_blendv_ps(low, high, _mm256_castsi256_ps(_mm256_slli_epi32(i, 28)));
}

#elif defined(__SSE2__)

// Saturation preserves signs.
inline std::uint64_t nonnegative_bits(const Halves& a) {
  return static_cast<std::uint16_t>(~_mm_movemask_epi8(_mm_packs_epi16(a.low, a.high)));
}

inline ByteMask byte_mask(std::uint64_t bits) {
  const __m128i lanes = spread_bits(bits);
  return lanes;
}

inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum, SignedByteBatch value) {
  return _mm_add_epi8(sum, _mm_and_si128(mask, value));
}

inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value) {
  return _mm_add_ps(sum, _mm_and_ps(mask, value));
}

inline LaneMask lane_mask(std::uint64_t bits) {
  const __m128i lane_bit = _mm_setr_epi32(1, 2, 4, 8);
  const __m128i all = _mm_set1_epi32(static_cast<int>(bits));
  return _mm_castsi128_ps(_mm_cmpeq_epi32(_mm_and_si128(all, lane_bit), lane_bit));
}

inline std::uint64_t bits_of(LaneMask lanes) {
  return static_cast<unsigned>(_mm_movemask_ps(lanes));
}

inline FloatBatch look_up_16(const float* table, FloatBatch index) {
  float indices[4];
  index.store_unaligned(indices);
  const auto entry = [&](int lane) { return table[static_cast<int>(indices[lane])]; };
  return _mm_setr_ps(entry(0), entry(1), entry(2), entry(3));
}

#elif defined(__aarch64__)

inline std::uint64_t nonnegative_bits(const Halves& a) {
  return bits_of_bytes(vcgezq_s8(vqmovn_high_s16(vqmovn_s16(a.low), a.high)));
}

inline ByteMask byte_mask(std::uint64_t bits) {
  return ByteMask(static_cast<uint8x16_t>(spread_bits(bits)));
}

inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum, SignedByteBatch value) {
  return vaddq_s8(sum, vandq_s8(vreinterpretq_s8_u8(mask), value));
}

inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value) {
  const uint32x4_t selected = vandq_u32(mask, vreinterpretq_u32_f32(value));
  return vaddq_f32(sum, vreinterpretq_f32_u32(selected));
}

inline LaneMask lane_mask(std::uint64_t bits) {
  constexpr std::uint32_t bit[] = {1, 2, 4, 8};
  return LaneMask(vtstq_u32(vdupq_n_u32(static_cast<std::uint32_t>(bits)), vld1q_u32(bit)));
}

inline std::uint64_t bits_of(LaneMask lanes) {
  return bits_of_lanes(lanes);
}

// 64 bytes are one table: lane i selects bytes 4 index to 4 index + 3.
inline FloatBatch look_up_16(const float* table, FloatBatch index) {
  const uint8x16x4_t bytes = vld1q_u8_x4(reinterpret_cast<const std::uint8_t*>(table));
  const uint32x4_t first = vmulq_n_u32(vcvtq_u32_f32(index), 0x04040404);
  const uint32x4_t places = vaddq_u32(first, vdupq_n_u32(0x03020100));
  return vreinterpretq_f32_u8(vqtbl4q_u8(bytes, vreinterpretq_u8_u32(places)));
}

#endif

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
