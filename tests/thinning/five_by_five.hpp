// All binary images of 5 x 5 pixels at once: cells on sheets, thinned a sheet at a time, and their
// topology by bit tricks.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "support/byte_image.hpp"

namespace thinbench::five_by_five {

/// An image of 5 x 5 pixels inside 8 x 8 bits: pixel (x, y) is bit 8 (y + 1) + x + 1.
using Cell = std::uint64_t;

inline constexpr Index kSide = 5;
inline constexpr std::uint32_t kCount = 1U << (kSide * kSide);
inline constexpr Cell kFrame = 0x007F7F7F7F7F7F7F;  // the pixels and a background pixel all round

/// Bit y * 5 + x of `code` is pixel (x, y).
constexpr Cell cell_of(std::uint32_t code) {
  Cell cell = 0;
  for (int y = 0; y < kSide; ++y) cell |= Cell{code >> (5 * y) & 31} << (8 * (y + 1) + 1);
  return cell;
}

/// The part of `within` that `seed` reaches by steps to direct neighbours and, if asked for, to
/// diagonal ones.
template <bool diagonals>
constexpr Cell reached(Cell seed, Cell within) {
  for (Cell before = 0; before != seed;) {
    before = seed;
    const Cell row = seed | seed << 1 | seed >> 1;
    const Cell from = diagonals ? row : seed;
    seed = (row | from << 8 | from >> 8) & within;
  }
  return seed;
}

/// 8-connected objects minus holes: corners - sides + faces of the union of closed squares.
constexpr int euler_number(Cell cell) {
  const Cell pairs = cell | cell << 1;
  return std::popcount(pairs | pairs << 8) - std::popcount(pairs) -
         std::popcount(cell | cell << 8) + std::popcount(cell);
}

/// Whether every object of `before` holds exactly one of `after`, and every background component of
/// `after` exactly one of `before`. Where all hold one at least, objects cannot become fewer nor
/// holes more, so that an equal Euler number means that both numbers are equal.
constexpr bool same_topology(Cell before, Cell after) {
  return (after & ~before) == 0 && reached<true>(after, before) == before &&
         reached<false>(kFrame & ~before, kFrame & ~after) == (kFrame & ~after) &&
         euler_number(before) == euler_number(after);
}

/// `kCells` images with background between them.
class Sheet {
 public:
  static constexpr Index kAcross = 256;
  static constexpr Index kDown = 128;
  static constexpr std::uint32_t kCells = kAcross * kDown;

  /// The images with the codes from `first` on.
  void fill(std::uint32_t first) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      for (Index y = 0; y < kSide; ++y) put_row(i, y, (first + i) >> (5 * y) & 31);
    }
  }

  [[nodiscard]] Cell cell(std::uint32_t i) const {
    Cell cell = 0;
    for (Index y = 0; y < kSide; ++y) cell |= row(i, y) << (8 * (y + 1) + 1);
    return cell;
  }

  [[nodiscard]] ImageView view() { return image_.view(); }

 private:
  static constexpr Index kPitch = 8;  // columns of a cell

  void put_row(std::uint32_t i, Index y, std::uint64_t bits) {
    // Bit k goes to byte k, from there to the byte's highest bit and down to its lowest.
    const std::uint64_t bytes =
        ((bits * 0x0101010101010101 & 0x8040201008040201) + 0x7F7F7F7F7F7F7F7F) >> 7 &
        0x0101010101010101;
    const std::uint64_t foreground = bytes * 255;
    std::memcpy(image_.view().row(y + i / kAcross * (kSide + 1)) + i % kAcross * kPitch,
                &foreground, sizeof foreground);
  }

  [[nodiscard]] std::uint64_t row(std::uint32_t i, Index y) const {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, image_.view().row(y + i / kAcross * (kSide + 1)) + i % kAcross * kPitch,
                sizeof bytes);
    return (bytes & 0x0101010101010101) * 0x0102040810204080 >> 56;
  }

  ByteImage image_{kAcross * kPitch, kDown*(kSide + 1)};
};

}  // namespace thinbench::five_by_five
