// The vocabulary in plain C++, independent of the order of bytes. The compiler turns most of its
// loops into the vector instructions of whatever it compiles for.
#pragma once

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
inline constexpr bool kHasByteLookUp = false;
inline constexpr bool kHasBitGather = false;

/// Bit i is set where `is_set(i)`, for `count` bits.
template <class IsSet>
[[gnu::always_inline]] inline std::uint64_t bits_where(std::size_t count, const IsSet& is_set) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < count; ++i) bits |= std::uint64_t{is_set(i)} << i;
  return bits;
}

inline std::uint64_t nonzero_bits(ByteBatch a) {
  return bits_where(ByteBatch::size, [&](std::size_t i) { return a[i] != 0; });
}

inline ByteBatch nonzero_bytes(ByteBatch a) {
  return ByteBatch::lanes([&](std::size_t i) { return a[i] != 0 ? 255 : 0; });
}

inline ByteBatch spread_bits(std::uint64_t bits) {
  return ByteBatch::lanes([&](std::size_t i) { return (bits >> i & 1) != 0 ? 255 : 0; });
}

inline std::uint64_t load_16_nonzero_bits(const std::uint8_t* from) {
  return nonzero_bits(ByteBatch::load_unaligned(from));
}

inline void store_16_spread_bits(std::uint8_t* to, std::uint64_t bits) {
  spread_bits(bits).store_unaligned(to);
}

inline void store_non_temporal(std::uint8_t* to, ByteBatch a) {
  a.store_unaligned(to);
}

inline void finish_non_temporal_stores() {}

inline std::uint32_t nonzero_lanes(Lanes16 a) {
  const auto is_set = [&](std::size_t i) { return a[i] != 0; };
  return static_cast<std::uint32_t>(bits_where(Lanes16::size, is_set));
}

inline std::uint32_t nonzero_lanes(Lanes32 a) {
  const auto is_set = [&](std::size_t i) { return a[i] != 0; };
  return static_cast<std::uint32_t>(bits_where(Lanes32::size, is_set));
}

inline std::uint32_t highest_bits(Lanes32 a) {
  return nonzero_lanes(a >> 31);
}

inline std::uint32_t lowest_bits(Lanes32 a) {
  return highest_bits(a << 31);
}

inline Lanes32 previous_lanes(const std::uint32_t* words, std::uint32_t first) {
  return Lanes32::lanes([&](std::size_t i) { return i > 0 ? words[i - 1] : first; });
}

inline Lanes32 next_lanes(const std::uint32_t* words, std::uint32_t last) {
  return Lanes32::lanes([&](std::size_t i) { return i + 1 < Lanes32::size ? words[i + 1] : last; });
}

inline WordBatch previous_in_pair(WordBatch a) {
  return WordBatch::lanes([&](std::size_t i) { return i % 2 == 1 ? a[i - 1] : 0; });
}

inline WordBatch next_in_pair(WordBatch a) {
  return WordBatch::lanes([&](std::size_t i) { return i % 2 == 0 ? a[i + 1] : 0; });
}

inline ByteBatch average(ByteBatch a, ByteBatch b) {
  return ByteBatch::lanes([&](std::size_t i) { return (a[i] + b[i] + 1) / 2; });
}

inline Halves interleaved(ByteBatch a, ByteBatch b) {
  const auto half = [&](std::size_t first) {
    return WideBatch::lanes([&](std::size_t i) { return a[first + i] | b[first + i] << 8; });
  };
  return {half(0), half(WideBatch::size)};
}

inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights) {
  return WideBatch::lanes([&](std::size_t i) {
    const int lower = (pairs[i] & 0xFF) * static_cast<std::int8_t>(weights[i] & 0xFF);
    return lower + (pairs[i] >> 8 & 0xFF) * (weights[i] >> 8);
  });
}

/// Byte i is value(lane) of the lane that is narrowed to byte i.
template <class Batch, class Value>
[[gnu::always_inline]] inline Batch narrowed(const Halves& a, const Value& value) {
  return Batch::lanes([&](std::size_t i) {
    return value(i < WideBatch::size ? a.low[i] : a.high[i - WideBatch::size]);
  });
}

inline ByteBatch pack(const Halves& a) {
  return narrowed<ByteBatch>(a, [](int lane) { return lane < 0 ? 0 : lane > 255 ? 255 : lane; });
}

inline ByteBatch first_repeated(ByteBatch a) {
  return ByteBatch::lanes([&](std::size_t i) { return a[i > 0 ? i - 1 : 0]; });
}

inline ByteBatch last_repeated(ByteBatch a) {
  return ByteBatch::lanes([&](std::size_t i) { return a[i + 1 < a.size ? i + 1 : i]; });
}

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
