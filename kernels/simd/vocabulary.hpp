// The vocabulary of vector operations. Each architecture file (sse2.hpp, avx2.hpp, avx512.hpp,
// neon.hpp) and portable.hpp define the functions declared here; only this directory and
// techniques/masked_lanes.hpp use intrinsics or test for an architecture. Kernels include
// vector.hpp. For ISA files only.
//
// Types and functions have the same name but another meaning in each ISA, so they are in an inline
// namespace of the ISA: otherwise the linker would merge functions that were not inlined.
//
// Lanes are numbered from low to high addresses, bits of words from low to high. Bits of a result
// beyond the number of lanes are 0 unless stated otherwise.
//
// An architecture file also defines these constants. A function marked with one of them exists only
// where it is true; kernels use it in `if constexpr`, with another algorithm as the alternative.
// - kHasFunnelShift: west_neighbour and east_neighbour in fewer instructions than two shifts and OR
// - kHasMaskedBytes: masked loads and stores of bytes
// - kHasCompress: compress-store of 32-bit lanes
// - kHasByteCompress: compress of bytes
// - kHasTranspose: transposition of a square of 32-bit lanes in registers
// - kHasPopcount: population count of each 64-bit lane
// - kHasByteLookUp: 16-byte tables and horizontal sums of bytes, faster than scalar popcnt
// - kHasLanePermute: permutations of 32-bit lanes by a vector of indices
// - kHasBitGather: gather and scatter of the bits of a 64-bit word (PEXT, PDEP)
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(THINBENCH_NO_SIMD)
#include "simd/portable_batch.hpp"
#else
#include <xsimd/xsimd.hpp>
#endif

#include "thinbench/image_view.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {

// Batches: xsimd's, or a stand-in for it.
#if defined(THINBENCH_NO_SIMD)
namespace simd = portable;
using BaselineArchitecture = portable::Registers;
#elif defined(__aarch64__)
namespace simd = xsimd;
using BaselineArchitecture = xsimd::neon64;
#else
namespace simd = xsimd;
using BaselineArchitecture = xsimd::sse2;
#endif

inline namespace THINBENCH_ISA {

inline constexpr Isa kThisIsa = Isa::THINBENCH_ISA;

template <Isa isa>
struct ArchitectureOf {
  using Type = BaselineArchitecture;
};
#if !defined(THINBENCH_NO_SIMD)
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
#endif

using Architecture = ArchitectureOf<kThisIsa>::Type;
template <class T>
using BatchOf = simd::batch<T, Architecture>;

using WordBatch = BatchOf<std::uint64_t>;  // 64 packed pixels per lane
using ByteBatch = BatchOf<std::uint8_t>;
using WideBatch = BatchOf<std::int16_t>;
using IntBatch = BatchOf<std::int32_t>;
using Lanes16 = BatchOf<std::uint16_t>;
using Lanes32 = BatchOf<std::uint32_t>;

/// In every batch.
inline constexpr Index kBatchBytes = static_cast<Index>(ByteBatch::size);

/// Bytes widened to 16 bits, in two halves, in the order of the unpack instructions (within 128
/// bits on AVX2 and AVX-512). `pack` restores the order; code in between must not depend on it.
struct Halves {
  WideBatch low;
  WideBatch high;
};

/// A square of 32-bit lanes.
struct Square {
  static constexpr Index kSize = static_cast<Index>(Lanes32::size);
  Lanes32 rows[std::size_t{kSize}];
};

/// Whether a register holds a row of up to 512 pixels.
inline constexpr bool kRegisterHoldsRow = 8 * sizeof(WordBatch) == 512;

// ---- Bytes and bits.

/// Bit i is set where byte i is not 0.
[[gnu::always_inline]] inline std::uint64_t nonzero_bits(ByteBatch a);

/// Byte i is 255 where byte i of `a` is not 0, else 0.
[[gnu::always_inline]] inline ByteBatch nonzero_bytes(ByteBatch a);

/// Byte i is 255 where bit i is set, else 0; bits beyond the lanes are ignored.
[[gnu::always_inline]] inline ByteBatch spread_bits(std::uint64_t bits);

/// Bit i is set where bit i of `mask` is set and byte i is not 0. Bytes outside the mask are not
/// read. Bits has 32 or 64 bits. [kHasMaskedBytes]
template <class Bits>
[[gnu::always_inline]] inline Bits load_nonzero_bits(const std::uint8_t* from, Bits mask);

/// Where bit i of `mask` is set, writes byte i: 255 if bit i of `bits` is set, else 0.
/// [kHasMaskedBytes]
template <class Bits>
[[gnu::always_inline]] inline void store_spread_bits(std::uint8_t* to, Bits bits, Bits mask);

/// nonzero_bits of 16 bytes in memory. [not kHasMaskedBytes]
[[gnu::always_inline]] inline std::uint64_t load_16_nonzero_bits(const std::uint8_t* from);

/// spread_bits to 16 bytes in memory. [not kHasMaskedBytes]
[[gnu::always_inline]] inline void store_16_spread_bits(std::uint8_t* to, std::uint64_t bits);

/// A non-temporal store; `to` must be aligned to the size of a batch.
[[gnu::always_inline]] inline void store_non_temporal(std::uint8_t* to, ByteBatch a);

/// Orders all preceding non-temporal stores before subsequent stores.
[[gnu::always_inline]] inline void finish_non_temporal_stores();

/// The bits of `word` selected by `mask`, moved to the low end (PEXT). [kHasBitGather]
[[gnu::always_inline]] inline std::uint64_t gather_bits(std::uint64_t word, std::uint64_t mask);

/// The low bits of `word`, moved to the positions of the set bits of `mask` (PDEP). [kHasBitGather]
[[gnu::always_inline]] inline std::uint64_t scatter_bits(std::uint64_t word, std::uint64_t mask);

/// The positions of the set bits, from low to high, then zeros. [kHasByteCompress]
[[gnu::always_inline]] inline ByteBatch set_bit_places(std::uint64_t bits);

/// The bytes of quarter `number`, zero-extended to 32 bits. [kHasByteCompress]
template <int number>
[[gnu::always_inline]] inline IntBatch widened_quarter(ByteBatch a);

// ---- Packed pixels, and lanes of flags.

/// Bit i is set where lane i is not 0.
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes16 a);
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes32 a);
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(WordBatch a);  // [kHasCompress]

/// Bit i is the highest or lowest bit of lane i.
[[gnu::always_inline]] inline std::uint32_t highest_bits(Lanes32 a);
[[gnu::always_inline]] inline std::uint32_t lowest_bits(Lanes32 a);

/// Lane i is words[i - 1], lane 0 is `first`; or words[i + 1], and the last lane is `last`. Words
/// are aligned, and words[-1], or the word after the last, is readable.
[[gnu::always_inline]] inline Lanes32 previous_lanes(const std::uint32_t* words,
                                                     std::uint32_t first);
[[gnu::always_inline]] inline Lanes32 next_lanes(const std::uint32_t* words, std::uint32_t last);

/// Stores nonzero_lanes(a), nonzero_lanes(b), lowest_bits(c) and highest_bits(c), 16 bits each,
/// from the low end. [kRegisterHoldsRow]
[[gnu::always_inline]] inline void store_lane_bits(std::uint64_t* to, Lanes32 a, Lanes32 b,
                                                   Lanes32 c);

/// The 16-bit quarters of 32 words, from the low end. [kRegisterHoldsRow]
struct WordQuarters {
  Lanes16 first, second, third, fourth;
};
[[gnu::always_inline]] inline WordQuarters quarters_of_words(const std::uint64_t* words);

/// a << count in each lane, filled with the highest bits of `low`. [kHasFunnelShift]
template <int count>
[[gnu::always_inline]] inline WordBatch funnel_left(WordBatch a, WordBatch low);
template <int count>
[[gnu::always_inline]] inline Lanes32 funnel_left(Lanes32 a, Lanes32 low);

/// a >> count in each lane, filled with the lowest bits of `high`. [kHasFunnelShift]
template <int count>
[[gnu::always_inline]] inline WordBatch funnel_right(WordBatch a, WordBatch high);
template <int count>
[[gnu::always_inline]] inline Lanes32 funnel_right(Lanes32 a, Lanes32 high);

/// Moves lanes within pairs: (a0, a1) to (0, a0), or to (a1, 0).
[[gnu::always_inline]] inline WordBatch previous_in_pair(WordBatch a);
[[gnu::always_inline]] inline WordBatch next_in_pair(WordBatch a);

/// Lane i is lane i - 1 (previous) or i + 1 (next) of `a`, or 0 if there is none.
/// [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch previous_word(WordBatch a);
[[gnu::always_inline]] inline WordBatch next_word(WordBatch a);

/// Lane i is lane i - 1 of `a`; lane 0 is the last lane of `before`. [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch previous_word(WordBatch a, WordBatch before);

/// The sum of `a`, `b` and the carry as numbers of 512 bits, lane 0 lowest; the carry, 0 or 1,
/// becomes that of the sum. [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch sum_with_carry(WordBatch a, WordBatch b,
                                                       std::uint64_t& carry);

/// The 512 pixels in reverse order. [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch reversed(WordBatch row);

/// Lane i is the sum of the lanes before it. [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch sums_before(WordBatch a);

/// Lane 0 is `word`, the others 0. [kRegisterHoldsRow]
template <class Block = WordBatch>
[[gnu::always_inline]] inline Block lowest_word(std::uint64_t word);

/// The 512 pixels rotated to the east by `pixels`, 0 <= pixels < 512. [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch rotated(WordBatch row, Index pixels);

/// Lane i of row j becomes lane j of row i. [kHasTranspose]
[[gnu::always_inline]] inline Square transposed(const Square& in);

/// Lane i is i. [kHasCompress]
[[gnu::always_inline]] inline Lanes32 lane_numbers();

/// Stores the lanes whose bits are set in `selected`, contiguously. Writes a whole register; bits
/// beyond the lanes are ignored. [kHasCompress]
[[gnu::always_inline]] inline void store_compressed(std::uint32_t* to, Lanes32 a,
                                                    std::uint32_t selected);

/// Lane i is the number of set bits among bits 0 to i. [kHasLanePermute]
[[gnu::always_inline]] inline Lanes32 counts_upto(std::uint32_t bits);

/// Lane i is lane index[i] of `a` where bit i of `selected` is set, else 0; bits beyond the lanes
/// are ignored. [kHasLanePermute]
[[gnu::always_inline]] inline Lanes32 permuted_where(Lanes32 a, Lanes32 index,
                                                     std::uint32_t selected);

/// Stores the first `count` lanes, fewer than all. [kHasLanePermute]
[[gnu::always_inline]] inline void store_first(std::uint32_t* to, Lanes32 a, Index count);

/// The number of set bits of each lane. [kHasPopcount]
[[gnu::always_inline]] inline WordBatch popcounts(WordBatch a);

/// Loads a table of 16 bytes for look_up. [kHasByteLookUp]
[[gnu::always_inline]] inline ByteBatch byte_table(const std::uint8_t* table);

/// Byte i is table[index[i]], for indices from 0 to 15. [kHasByteLookUp]
[[gnu::always_inline]] inline ByteBatch look_up(ByteBatch table, ByteBatch index);

/// The sum of the eight bytes of each 64-bit lane. [kHasByteLookUp]
[[gnu::always_inline]] inline WordBatch byte_sums(ByteBatch a);

/// The sum of all lanes, modulo 2^64. [kHasPopcount or kHasByteLookUp]
[[gnu::always_inline]] inline std::int64_t sum_of_lanes(WordBatch a);

// ---- Grey levels and 8-bit arithmetic.

/// (a + b + 1) / 2.
[[gnu::always_inline]] inline ByteBatch average(ByteBatch a, ByteBatch b);

/// Pairs of bytes in 16-bit lanes: a in the lower byte, b in the upper one.
[[gnu::always_inline]] inline Halves interleaved(ByteBatch a, ByteBatch b);

/// In each lane: lower byte of pair * lower byte of weight + upper byte of pair * upper byte of
/// weight. Pairs are unsigned, weights signed; the sum must fit 16 bits.
[[gnu::always_inline]] inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights);

/// Narrows to bytes, in order, saturating to [0, 255].
[[gnu::always_inline]] inline ByteBatch pack(const Halves& a);

/// Byte i is byte i - 1 of `a`; byte 0 is byte 0.
[[gnu::always_inline]] inline ByteBatch first_repeated(ByteBatch a);

/// Byte i is byte i + 1 of `a`; the last byte is the last byte.
[[gnu::always_inline]] inline ByteBatch last_repeated(ByteBatch a);

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
