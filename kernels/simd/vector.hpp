// Vectors for kernels: vocabulary.hpp as this ISA's architecture implements it, functions built on
// it, and batches as words. Hides differences between versions of xsimd. ISA files include this
// header.
#pragma once

#include "simd/vocabulary.hpp"
#include "simd/word.hpp"

#if defined(THINBENCH_NO_SIMD)
#include "simd/portable.hpp"
#elif defined(__AVX512BW__)
#include "simd/avx512.hpp"
#elif defined(__AVX2__)
#include "simd/avx2.hpp"
#elif defined(__SSE2__)
#include "simd/sse2.hpp"
#elif defined(__aarch64__)
#include "simd/neon.hpp"
#else
#error "no file of kernels/simd/ defines the vocabulary for this architecture"
#endif

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

/// The same bits as lanes of another type.
template <class To, class From>
[[gnu::always_inline]] inline To reinterpreted(const From& from) {
  return __builtin_bit_cast(typename To::register_type,
                            static_cast<typename From::register_type>(from));
}

template <class T, class A>
[[gnu::always_inline]] inline bool any_bit(const simd::batch<T, A>& batch) {
  return simd::any(batch != simd::batch<T, A>(T{0}));
}

/// The west neighbours of packed pixels: each lane shifted by `pixels` towards high bits, filled
/// with the highest bits of `before`.
template <int pixels, class T, class A>
[[gnu::always_inline]] inline simd::batch<T, A> west_neighbour(const simd::batch<T, A>& centre,
                                                               const simd::batch<T, A>& before) {
  if constexpr (kHasFunnelShift) {
    return funnel_left<pixels>(centre, before);
  } else {
    return (centre << pixels) | (before >> (8 * static_cast<int>(sizeof(T)) - pixels));
  }
}

/// The east neighbours: shifted towards low bits, filled with the lowest bits of `after`.
template <int pixels, class T, class A>
[[gnu::always_inline]] inline simd::batch<T, A> east_neighbour(const simd::batch<T, A>& centre,
                                                               const simd::batch<T, A>& after) {
  if constexpr (kHasFunnelShift) {
    return funnel_right<pixels>(centre, after);
  } else {
    return (centre >> pixels) | (after << (8 * static_cast<int>(sizeof(T)) - pixels));
  }
}

[[gnu::always_inline]] inline Halves operator+(const Halves& a, const Halves& b) {
  return {a.low + b.low, a.high + b.high};
}

[[gnu::always_inline]] inline Halves operator-(const Halves& a, const Halves& b) {
  return {a.low - b.low, a.high - b.high};
}

[[gnu::always_inline]] inline Halves absolute(const Halves& a) {
  return {simd::abs(a.low), simd::abs(a.high)};
}

[[gnu::always_inline]] inline Halves maximum(const Halves& a, const Halves& b) {
  return {simd::max(a.low, b.low), simd::max(a.high, b.high)};
}

/// a - b for values from 0 to 32767; `pack` saturates negative results to 0.
[[gnu::always_inline]] inline Halves excess(const Halves& a, WideBatch b) {
  return {simd::ssub(a.low, b), simd::ssub(a.high, b)};
}

/// max(a - b, 0).
[[gnu::always_inline]] inline ByteBatch excess(ByteBatch a, ByteBatch b) {
  return simd::ssub(a, b);
}

/// |a - b|.
[[gnu::always_inline]] inline ByteBatch distance(ByteBatch a, ByteBatch b) {
  return simd::ssub(a, b) | simd::ssub(b, a);
}

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

// Specialisations belong to the namespace of their template, outside that of the ISA.

/// Byte lanes, one pixel each: neighbours are one element away.
template <>
struct WordTraits<ByteBatch> {
  using Element = std::uint8_t;
  using Word = ByteBatch;
  static constexpr Index kElements = static_cast<Index>(Word::size);
  [[gnu::always_inline]] static Word load(const Element* from) {
    return Word::load_unaligned(from);
  }
  [[gnu::always_inline]] static void store(Element* to, Word word) { word.store_unaligned(to); }
  [[gnu::always_inline]] static Word west(Word, const Element* from) { return load(from - 1); }
  [[gnu::always_inline]] static Word east(Word, const Element* from) { return load(from + 1); }
  [[gnu::always_inline]] static Word west2(Word, const Element* from) { return load(from - 2); }
  [[gnu::always_inline]] static Word east2(Word, const Element* from) { return load(from + 2); }
  [[gnu::always_inline]] static Word zero() { return Word(Element{0}); }
  [[gnu::always_inline]] static bool any(Word word) { return any_bit(word); }
};

/// Packed pixels, 64 per lane. The bit from the adjacent lane comes from an unaligned load one word
/// away, which avoids a lane-crossing shuffle.
template <>
struct WordTraits<WordBatch> {
  using Element = std::uint64_t;
  using Word = WordBatch;
  static constexpr Index kElements = static_cast<Index>(Word::size);
  [[gnu::always_inline]] static Word load(const Element* from) {
    return Word::load_unaligned(from);
  }
  [[gnu::always_inline]] static void store(Element* to, Word word) { word.store_unaligned(to); }
  [[gnu::always_inline]] static Word west(Word centre, const Element* from) {
    return west_neighbour<1>(centre, load(from - 1));
  }
  [[gnu::always_inline]] static Word east(Word centre, const Element* from) {
    return east_neighbour<1>(centre, load(from + 1));
  }
  [[gnu::always_inline]] static Word west2(Word centre, const Element* from) {
    return west_neighbour<2>(centre, load(from - 1));
  }
  [[gnu::always_inline]] static Word east2(Word centre, const Element* from) {
    return east_neighbour<2>(centre, load(from + 1));
  }
  [[gnu::always_inline]] static Word zero() { return Word(Element{0}); }
  [[gnu::always_inline]] static bool any(Word word) { return any_bit(word); }
};

}  // namespace thinbench::detail
