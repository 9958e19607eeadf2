// A row of up to 64 pixels between bytes and the bits of one word. For ISA files only.
//
// AVX-512 masks bytes; elsewhere pieces of 16 bytes are moved, of which the last ends with the row
// and may overlap the one before.
#pragma once

#include "simd/batch.hpp"

namespace thinbench::detail {

#ifdef __AVX512BW__

[[gnu::always_inline]] inline std::uint64_t first_bits(Index count) {
  return count == 0 ? 0 : ~std::uint64_t{0} >> (kWordBits - count);
}

/// Bit x is set where byte x of `width`, 0 to the bits of Bits, is not zero.
template <class Bits>
[[gnu::always_inline]] inline Bits pack_pixels(const std::uint8_t* row, Index width) {
  if constexpr (sizeof(Bits) == 4) {
    const auto mask = static_cast<__mmask32>(first_bits(width));
    const __m256i lanes = _mm256_maskz_loadu_epi8(mask, row);
    return _mm256_test_epi8_mask(lanes, lanes);
  } else {
    const __m512i lanes = _mm512_maskz_loadu_epi8(first_bits(width), row);
    return _mm512_test_epi8_mask(lanes, lanes);
  }
}

/// The other way round: writes 0 and 255, `width` bytes and no more.
template <class Bits>
[[gnu::always_inline]] inline void unpack_pixels(Bits bits, std::uint8_t* row, Index width) {
  if constexpr (sizeof(Bits) == 4) {
    const auto mask = static_cast<__mmask32>(first_bits(width));
    _mm256_mask_storeu_epi8(row, mask, _mm256_movm_epi8(bits));
  } else {
    _mm512_mask_storeu_epi8(row, first_bits(width), _mm512_movm_epi8(bits));
  }
}

#else

inline constexpr Index kPiece = 16;

[[gnu::always_inline]] inline std::uint64_t pack_piece(const std::uint8_t* bytes) {
  const __m128i lanes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes));
  const auto light = _mm_movemask_epi8(_mm_cmpeq_epi8(lanes, _mm_setzero_si128()));
  return static_cast<std::uint16_t>(~light);
}

[[gnu::always_inline]] inline void unpack_piece(std::uint64_t bits, std::uint8_t* bytes) {
#ifdef __AVX2__
  const __m128i lanes = _mm256_castsi256_si128(spread_bits(bits));
#else
  const __m128i lanes = spread_bits(bits);
#endif
  _mm_storeu_si128(reinterpret_cast<__m128i*>(bytes), lanes);
}

/// Calls `piece(x)` for pieces that cover a row of at least one piece.
template <class Piece>
[[gnu::always_inline]] inline void for_pieces(Index width, const Piece& piece) {
  for (Index x = 0; x + kPiece <= width; x += kPiece) piece(x);
  if (width % kPiece != 0) piece(width - kPiece);
}

template <class Bits>
[[gnu::always_inline]] inline Bits pack_pixels(const std::uint8_t* row, Index width) {
  std::uint64_t bits = 0;
  if (width >= kPiece) {
    for_pieces(width, [&](Index x) { bits |= pack_piece(row + x) << x; });
  } else {
    for (Index x = 0; x < width; ++x) bits |= std::uint64_t{row[x] != 0} << x;
  }
  return static_cast<Bits>(bits);
}

template <class Bits>
[[gnu::always_inline]] inline void unpack_pixels(Bits bits, std::uint8_t* row, Index width) {
  if (width >= kPiece) {
    for_pieces(width, [&](Index x) { unpack_piece(bits >> x, row + x); });
  } else {
    for (Index x = 0; x < width; ++x) row[x] = (bits >> x & 1) != 0 ? 255 : 0;
  }
}

#endif

}  // namespace thinbench::detail
