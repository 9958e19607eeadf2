// Packs up to 64 bytes of a row into the bits of one word, and unpacks them. For ISA files only.
//
// ISAs with masked byte access do this in one step. Others use chunks of 16 bytes; the last chunk
// ends at the end of the row and may overlap the one before.
#pragma once

#include "core/plane_view.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {

[[gnu::always_inline]] inline std::uint64_t first_bits(Index count) {
  return count == 0 ? 0 : ~std::uint64_t{0} >> (kWordBits - count);
}

inline constexpr Index kChunk = 16;

/// Calls `body(x)` for chunks that cover a row. Requires width >= kChunk.
template <class Body>
[[gnu::always_inline]] inline void for_chunks(Index width, const Body& body) {
  for (Index x = 0; x + kChunk <= width; x += kChunk) body(x);
  if (width % kChunk != 0) body(width - kChunk);
}

/// Sets bit x if byte x is not zero. `width` is 0 to the number of bits of Bits.
template <class Bits>
[[gnu::always_inline]] inline Bits pack_pixels(const std::uint8_t* row, Index width) {
  if constexpr (kHasMaskedBytes) {
    return load_nonzero_bits(row, static_cast<Bits>(first_bits(width)));
  } else {
    std::uint64_t bits = 0;
    if (width >= kChunk) {
      for_chunks(width, [&](Index x) { bits |= load_16_nonzero_bits(row + x) << x; });
    } else {
      for (Index x = 0; x < width; ++x) bits |= std::uint64_t{row[x] != 0} << x;
    }
    return static_cast<Bits>(bits);
  }
}

/// Writes `width` bytes, 255 where bit x is set, else 0.
template <class Bits>
[[gnu::always_inline]] inline void unpack_pixels(Bits bits, std::uint8_t* row, Index width) {
  if constexpr (kHasMaskedBytes) {
    store_spread_bits(row, bits, static_cast<Bits>(first_bits(width)));
  } else if (width >= kChunk) {
    for_chunks(width, [&](Index x) { store_16_spread_bits(row + x, bits >> x); });
  } else {
    for (Index x = 0; x < width; ++x) row[x] = (bits >> x & 1) != 0 ? 255 : 0;
  }
}

}  // namespace thinbench::detail
