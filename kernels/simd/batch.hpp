// The xsimd shim: everything that differs between xsimd versions or that xsimd lacks. For ISA files
// only; the architecture follows from THINBENCH_ISA, which the build sets for each of them.
#pragma once

#include <xsimd/xsimd.hpp>

#include "thinbench/isa.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

template <Isa isa>
struct ArchitectureOf;
template <>
struct ArchitectureOf<Isa::baseline> {
  using Type = xsimd::sse2;
};
template <>
struct ArchitectureOf<Isa::sse42> {
  using Type = xsimd::sse4_2;
};
template <>
struct ArchitectureOf<Isa::avx2> {
  using Type = xsimd::avx2;
};
template <>
struct ArchitectureOf<Isa::avx512> {
  using Type = xsimd::avx512bw;
};
template <>
struct ArchitectureOf<Isa::avx512icl> {
  using Type = xsimd::avx512bw;
};

inline constexpr Isa kThisIsa = Isa::THINBENCH_ISA;
using Architecture = ArchitectureOf<kThisIsa>::Type;
using WordBatch = xsimd::batch<std::uint64_t, Architecture>;
using ByteBatch = xsimd::batch<std::uint8_t, Architecture>;

template <class T, class A>
[[gnu::always_inline]] inline bool any_bit(const xsimd::batch<T, A>& batch) {
  return xsimd::any(batch != xsimd::batch<T, A>(T{0}));
}

/// Packed pixels moved by `pixels` towards high bits in each lane; the bits that come in are the
/// highest of `before`.
template <int pixels, class T, class A>
[[gnu::always_inline]] inline xsimd::batch<T, A> west_neighbour(const xsimd::batch<T, A>& centre,
                                                           const xsimd::batch<T, A>& before) {
#ifdef __AVX512VBMI2__
  if constexpr (sizeof(T) == 8) return _mm512_shldi_epi64(centre, before, pixels);
  if constexpr (sizeof(T) == 4) return _mm512_shldi_epi32(centre, before, pixels);
#else
  return (centre << pixels) | (before >> (8 * static_cast<int>(sizeof(T)) - pixels));
#endif
}

/// The same towards low bits; the lowest of `after` come in.
template <int pixels, class T, class A>
[[gnu::always_inline]] inline xsimd::batch<T, A> east_neighbour(const xsimd::batch<T, A>& centre,
                                                           const xsimd::batch<T, A>& after) {
#ifdef __AVX512VBMI2__
  if constexpr (sizeof(T) == 8) return _mm512_shrdi_epi64(centre, after, pixels);
  if constexpr (sizeof(T) == 4) return _mm512_shrdi_epi32(centre, after, pixels);
#else
  return (centre >> pixels) | (after << (8 * static_cast<int>(sizeof(T)) - pixels));
#endif
}

/// Byte lanes, one pixel each: neighbours are one element away.
template <class A>
struct WordTraits<xsimd::batch<std::uint8_t, A>> {
  using Element = std::uint8_t;
  using Word = xsimd::batch<std::uint8_t, A>;
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

/// Packed pixels, 64 a lane. The bit that crosses a lane comes from an unaligned load one word
/// away, which needs no lane-crossing shuffle; with VBMI2 the two shifts and the OR are one funnel
/// shift.
template <class A>
struct WordTraits<xsimd::batch<std::uint64_t, A>> {
  using Element = std::uint64_t;
  using Word = xsimd::batch<std::uint64_t, A>;
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

#ifdef __AVX512F__
/// vpternlog: every gate with three inputs is one instruction.
template <class T>
struct TernaryGate<xsimd::batch<T, xsimd::avx512bw>> {
  using Word = xsimd::batch<T, xsimd::avx512bw>;
  static constexpr bool kOneInstruction = true;

  template <class Gate>
  [[gnu::always_inline]] static Word apply(Word a, Word b, Word c, Gate gate) {
    return _mm512_ternarylogic_epi64(a, b, c, truth_table(gate));
  }
};
#endif

/// A byte a lane, 255 where the bit of `bits` is set and 0 elsewhere; bits beyond the lanes do not
/// count.
[[gnu::always_inline]] inline ByteBatch spread_bits(std::uint64_t bits) {
#if defined(__AVX512BW__)
  return _mm512_movm_epi8(bits);
#elif defined(__AVX2__)
  // Byte lane i tests bit i % 8 of source byte i / 8:
  //   lanes  0 1 .. 7 | 8 .. 15 | 16 .. 23 | 24 .. 31
  //   byte   0 0 .. 0 | 1 ..  1 |  2 ..  2 |  3 ..  3
  const __m256i which =
      _mm256_setr_epi64x(0, 0x0101010101010101, 0x0202020202020202, 0x0303030303030303);
  const __m256i bit = _mm256_set1_epi64x(static_cast<long long>(0x8040201008040201));
  const __m256i all = _mm256_set1_epi32(static_cast<int>(bits));
  return _mm256_cmpeq_epi8(_mm256_and_si256(_mm256_shuffle_epi8(all, which), bit), bit);
#else
  // The same with 16 lanes; the two source bytes are doubled by unpacking instead of shuffling.
  const __m128i bit = _mm_set1_epi64x(static_cast<long long>(0x8040201008040201));
  const __m128i word = _mm_cvtsi32_si128(static_cast<int>(bits));
  const __m128i pairs = _mm_unpacklo_epi8(word, word);
  const __m128i fours = _mm_unpacklo_epi16(pairs, pairs);
  const __m128i all = _mm_unpacklo_epi32(fours, fours);
  return _mm_cmpeq_epi8(_mm_and_si128(all, bit), bit);
#endif
}

}  // namespace thinbench::detail
