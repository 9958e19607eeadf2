// A row of up to 64 pixels between bytes and the bits of one word. For ISA files only.
//
// With masked loads and stores of bytes at once; elsewhere in pieces of 16 bytes, of which the last
// ends with the row and may overlap the one before.
#pragma once

#include "image/plane_view.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {

[[gnu::always_inline]] inline std::uint64_t first_bits(Index count) {
  return count == 0 ? 0 : ~std::uint64_t{0} >> (kWordBits - count);
}

inline constexpr Index kPiece = 16;

/// Calls `piece(x)` for pieces that cover a row of at least one piece.
template <class Piece>
[[gnu::always_inline]] inline void for_pieces(Index width, const Piece& piece) {
  for (Index x = 0; x + kPiece <= width; x += kPiece) piece(x);
  if (width % kPiece != 0) piece(width - kPiece);
}

/// Bit x is set where byte x of `width`, 0 to the bits of Bits, is not zero.
template <class Bits>
[[gnu::always_inline]] inline Bits pack_pixels(const std::uint8_t* row, Index width) {
  if constexpr (kHasMaskedBytes) {
    return load_nonzero_bits(row, static_cast<Bits>(first_bits(width)));
  } else {
    std::uint64_t bits = 0;
    if (width >= kPiece) {
      for_pieces(width, [&](Index x) { bits |= load_16_nonzero_bits(row + x) << x; });
    } else {
      for (Index x = 0; x < width; ++x) bits |= std::uint64_t{row[x] != 0} << x;
    }
    return static_cast<Bits>(bits);
  }
}

/// The other way round: writes 0 and 255, `width` bytes and no more.
template <class Bits>
[[gnu::always_inline]] inline void unpack_pixels(Bits bits, std::uint8_t* row, Index width) {
  if constexpr (kHasMaskedBytes) {
    store_spread_bits(row, bits, static_cast<Bits>(first_bits(width)));
  } else if (width >= kPiece) {
    for_pieces(width, [&](Index x) { store_16_spread_bits(row + x, bits >> x); });
  } else {
    for (Index x = 0; x < width; ++x) row[x] = (bits >> x & 1) != 0 ? 255 : 0;
  }
}

}  // namespace thinbench::detail
