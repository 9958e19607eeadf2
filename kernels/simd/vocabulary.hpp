// The vocabulary of vector operations: all that kernels may say about vectors. Every architecture
// file (sse2.hpp, avx2.hpp, avx512.hpp) defines the functions that are declared here, and only this
// directory names instructions or asks which architecture it is compiled for. Kernels include
// vector.hpp. For ISA files only.
//
// Types and functions have one name and another meaning for each ISA, so they stand in an inline
// namespace of the ISA: the linker would merge whatever a compiler does not inline.
//
// Lanes are numbered from low to high addresses, and so are the bits of words. Bits of a result
// beyond the number of lanes are 0 unless stated otherwise.
//
// An architecture file also defines these constants. Functions marked with one of them exist where
// it is true; kernels use them in `if constexpr`, with another algorithm as the alternative.
//   kHasFunnelShift   west_neighbour and east_neighbour in one instruction
//   kHasMaskedBytes   loads and stores of some bytes of a register
//   kHasCompress      lanes of 32 bits that a mask selects, one after another
//   kHasByteCompress  the same for bytes
//   kHasTranspose     a square of 32-bit lanes, transposed in registers
//   kHasPopcount      the set bits of each 64-bit lane
//   kHasByteLookUp    tables of 16 bytes and horizontal sums of bytes, faster than a scalar
//   popcount kHasBitGather     bits of a 64-bit word that a mask selects, one after another, and
//   back
#pragma once

#include <cstddef>
#include <cstdint>

#include <xsimd/xsimd.hpp>

#include "thinbench/image_view.hpp"
#include "thinbench/isa.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

inline constexpr Isa kThisIsa = Isa::THINBENCH_ISA;

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

using Architecture = ArchitectureOf<kThisIsa>::Type;
template <class T>
using BatchOf = xsimd::batch<T, Architecture>;

using WordBatch = BatchOf<std::uint64_t>;  // 64 packed pixels a lane
using ByteBatch = BatchOf<std::uint8_t>;
using SignedByteBatch = BatchOf<std::int8_t>;
using WideBatch = BatchOf<std::int16_t>;
using IntBatch = BatchOf<std::int32_t>;
using FloatBatch = BatchOf<float>;
using Lanes16 = BatchOf<std::uint16_t>;
using Lanes32 = BatchOf<std::uint32_t>;

/// Lanes chosen: a mask register where there is one, all-ones lanes elsewhere.
using LaneMask = xsimd::batch_bool<float, Architecture>;
using ByteMask = xsimd::batch_bool<std::uint8_t, Architecture>;

/// Bytes widened to 16 bits, in two halves, interleaved as the processor does it, within 128 bits
/// on AVX2 and AVX-512. `pack` undoes that; nothing between may depend on the order of lanes.
struct Halves {
  WideBatch low;
  WideBatch high;
};

/// As many rows of 32-bit lanes as a row has lanes.
struct Square {
  static constexpr Index kSize = static_cast<Index>(Lanes32::size);
  Lanes32 rows[std::size_t{kSize}];
};

/// Whether rows of up to 512 pixels fit one register.
inline constexpr bool kRegisterHoldsRow = 8 * sizeof(WordBatch) == 512;

// ---- Bytes and bits.

/// Bit i is set where byte i is not 0.
[[gnu::always_inline]] inline std::uint64_t nonzero_bits(ByteBatch a);

/// Byte i is 255 where byte i of `a` is not 0, else 0.
[[gnu::always_inline]] inline ByteBatch nonzero_bytes(ByteBatch a);

/// Byte i is 255 where bit i is set, else 0; bits beyond the lanes do not count.
[[gnu::always_inline]] inline ByteBatch spread_bits(std::uint64_t bits);

/// Bit i is set where bit i of `mask` is and byte i is not 0. Bytes outside the mask are not read.
/// Bits has 32 or 64 bits. [kHasMaskedBytes]
template <class Bits>
[[gnu::always_inline]] inline Bits load_nonzero_bits(const std::uint8_t* from, Bits mask);

/// Writes byte i where bit i of `mask` is set, 255 where bit i of `bits` is, else 0.
/// [kHasMaskedBytes]
template <class Bits>
[[gnu::always_inline]] inline void store_spread_bits(std::uint8_t* to, Bits bits, Bits mask);

/// nonzero_bits of 16 bytes in memory. [not kHasMaskedBytes]
[[gnu::always_inline]] inline std::uint64_t load_16_nonzero_bits(const std::uint8_t* from);

/// spread_bits to 16 bytes in memory. [not kHasMaskedBytes]
[[gnu::always_inline]] inline void store_16_spread_bits(std::uint8_t* to, std::uint64_t bits);

/// A non-temporal store; `to` is aligned to the size of a batch.
[[gnu::always_inline]] inline void store_non_temporal(std::uint8_t* to, ByteBatch a);

/// After the last of some non-temporal stores: orders them before what follows.
[[gnu::always_inline]] inline void finish_non_temporal_stores();

/// The bits of `word` that `mask` selects, moved together at the low end. [kHasBitGather]
[[gnu::always_inline]] inline std::uint64_t gather_bits(std::uint64_t word, std::uint64_t mask);

/// The low bits of `word`, one after another, in the places of the bits of `mask`. [kHasBitGather]
[[gnu::always_inline]] inline std::uint64_t scatter_bits(std::uint64_t word, std::uint64_t mask);

/// The places of the set bits, from low to high, then zeros. [kHasByteCompress]
[[gnu::always_inline]] inline ByteBatch set_bit_places(std::uint64_t bits);

/// Lane i is byte i of the quarter with that number. [kHasByteCompress]
template <int number>
[[gnu::always_inline]] inline IntBatch widened_quarter(ByteBatch a);

// ---- Packed pixels, and lanes of flags.

/// Bit i is set where lane i is not 0.
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes16 a);
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(Lanes32 a);
[[gnu::always_inline]] inline std::uint32_t nonzero_lanes(WordBatch a);  // [kRegisterHoldsRow]

/// Bit i is the highest or lowest bit of lane i.
[[gnu::always_inline]] inline std::uint32_t highest_bits(Lanes32 a);
[[gnu::always_inline]] inline std::uint32_t lowest_bits(Lanes32 a);

/// a << count in each lane, where the highest bits of `low` come in. [kHasFunnelShift]
template <int count>
[[gnu::always_inline]] inline WordBatch funnel_left(WordBatch a, WordBatch low);
template <int count>
[[gnu::always_inline]] inline Lanes32 funnel_left(Lanes32 a, Lanes32 low);

/// a >> count in each lane, where the lowest bits of `high` come in. [kHasFunnelShift]
template <int count>
[[gnu::always_inline]] inline WordBatch funnel_right(WordBatch a, WordBatch high);
template <int count>
[[gnu::always_inline]] inline Lanes32 funnel_right(Lanes32 a, Lanes32 high);

/// With lanes in pairs: the first lane of a pair in place of the second, and 0 in place of the
/// first; or the second in place of the first, and 0 in place of the second.
[[gnu::always_inline]] inline WordBatch previous_in_pair(WordBatch a);
[[gnu::always_inline]] inline WordBatch next_in_pair(WordBatch a);

/// Lane i is lane i - 1 (lane i + 1) of `a`, and 0 where there is none. [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch previous_word(WordBatch a);
[[gnu::always_inline]] inline WordBatch next_word(WordBatch a);

/// The pixels of a register moved by `pixels` to the east, in a ring; 0 <= pixels < 512.
/// [kRegisterHoldsRow]
[[gnu::always_inline]] inline WordBatch rotated(WordBatch row, Index pixels);

/// Lane i of row j becomes lane j of row i. [kHasTranspose]
[[gnu::always_inline]] inline Square transposed(const Square& in);

/// Lane i is i. [kHasCompress]
[[gnu::always_inline]] inline Lanes32 lane_numbers();

/// Stores the lanes whose bits are set in `selected`, one after another. A whole register is
/// written; bits beyond the lanes do not count. [kHasCompress]
[[gnu::always_inline]] inline void store_compressed(std::uint32_t* to, Lanes32 a,
                                                    std::uint32_t selected);

/// The number of set bits of each lane. [kHasPopcount]
[[gnu::always_inline]] inline WordBatch popcounts(WordBatch a);

/// A table of 16 bytes, ready for look_up. [kHasByteLookUp]
[[gnu::always_inline]] inline ByteBatch byte_table(const std::uint8_t* table);

/// Byte i is table[index of byte i], for indices from 0 to 15. [kHasByteLookUp]
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

/// lower byte of the pair * lower byte of the weight + the same of the upper bytes: pairs are
/// unsigned, weights signed, and the sum must fit 16 bits.
[[gnu::always_inline]] inline WideBatch weighted_pairs(WideBatch pairs, WideBatch weights);

/// Bytes again, in order; what is below 0 becomes 0, what is above 255 becomes 255.
[[gnu::always_inline]] inline ByteBatch pack(const Halves& a);

/// Bit i is set where the lane that `pack` makes byte i of is not negative.
[[gnu::always_inline]] inline std::uint64_t nonnegative_bits(const Halves& a);

/// Byte i is byte i - 1 of `a`, byte 0 stays.
[[gnu::always_inline]] inline ByteBatch first_repeated(ByteBatch a);

/// Byte i is byte i + 1 of `a`, the last byte stays.
[[gnu::always_inline]] inline ByteBatch last_repeated(ByteBatch a);

/// The bytes whose bits are set; bits beyond the lanes do not count.
[[gnu::always_inline]] inline ByteMask byte_mask(std::uint64_t bits);

/// sum + value in the lanes of `mask`, sum elsewhere: sum + value * n for inputs n of 0 and 1.
[[gnu::always_inline]] inline SignedByteBatch add_where(ByteMask mask, SignedByteBatch sum,
                                                        SignedByteBatch value);
[[gnu::always_inline]] inline FloatBatch add_where(LaneMask mask, FloatBatch sum, FloatBatch value);

// ---- Single precision.

/// The lanes whose bits are set; bits beyond the lanes do not count.
[[gnu::always_inline]] inline LaneMask lane_mask(std::uint64_t bits);

/// Bit i is lane i.
[[gnu::always_inline]] inline std::uint64_t bits_of(LaneMask lanes);

/// As many bytes as a batch has lanes, each converted to a number.
[[gnu::always_inline]] inline FloatBatch load_bytes(const std::uint8_t* from);

/// table[index] for indices 0.0 to 15.0.
[[gnu::always_inline]] inline FloatBatch look_up_16(const float* table, FloatBatch index);

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
