// All binary images of 5 x 5 pixels: tiled into sheets, which are thinned as one image; and their
// topology by bit operations.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "support/byte_image.hpp"

namespace thinbench::five_by_five {

/// An image of 5 x 5 pixels in a bit board of 8 x 8: pixel (x, y) is bit 8 (y + 1) + x + 1.
using Cell = std::uint64_t;

inline constexpr Index kSide = 5;
inline constexpr std::uint32_t kCount = 1U << (kSide * kSide);
inline constexpr Cell kCellWithMargin = 0x007F7F7F7F7F7F7F;  // the pixels and a margin of one

/// Bit y * 5 + x of `code` is pixel (x, y).
constexpr Cell cell_of(std::uint32_t code) {
  Cell cell = 0;
  for (int y = 0; y < kSide; ++y) cell |= Cell{code >> (5 * y) & 31} << (8 * (y + 1) + 1);
  return cell;
}

/// Flood fill: the pixels of `within` that are connected with `seed`, by 4- or 8-connectivity.
template <bool eight_connected>
constexpr Cell reached(Cell seed, Cell within) {
  for (Cell before = 0; before != seed;) {
    before = seed;
    const Cell row = seed | seed << 1 | seed >> 1;
    const Cell from = eight_connected ? row : seed;
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

/// Whether every object of `before` contains exactly one of `after`, and every background component
/// of `after` exactly one of `before`. If each contains at least one, the number of objects cannot
/// fall and that of holes cannot rise, so equal Euler numbers mean that both numbers are equal.
constexpr bool same_topology(Cell before, Cell after) {
  return (after & ~before) == 0 && reached<true>(after, before) == before &&
         reached<false>(kCellWithMargin & ~before, kCellWithMargin & ~after) ==
             (kCellWithMargin & ~after) &&
         euler_number(before) == euler_number(after);
}

/// A grid of `kCells` images, separated by background.
class Sheet {
 public:
  static constexpr Index kColumns = 256;  // of images
  static constexpr Index kRows = 128;
  static constexpr std::uint32_t kCells = kColumns * kRows;

  /// Draws the images with codes `first`, `first` + 1, ...
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
  static constexpr Index kPitch = 8;  // pixels from image to image

  void put_row(std::uint32_t i, Index y, std::uint64_t bits) {
    // Expands bit k to byte k: the mask selects it from copies of all bits, the addition carries it
    // to the byte's highest bit, and the shift moves it to the lowest.
    const std::uint64_t bytes =
        ((bits * 0x0101010101010101 & 0x8040201008040201) + 0x7F7F7F7F7F7F7F7F) >> 7 &
        0x0101010101010101;
    const std::uint64_t foreground = bytes * 255;
    std::memcpy(image_.view().row(y + i / kColumns * (kSide + 1)) + i % kColumns * kPitch,
                &foreground, sizeof foreground);
  }

  [[nodiscard]] std::uint64_t row(std::uint32_t i, Index y) const {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, image_.view().row(y + i / kColumns * (kSide + 1)) + i % kColumns * kPitch,
                sizeof bytes);
    return (bytes & 0x0101010101010101) * 0x0102040810204080 >> 56;
  }

  ByteImage image_{kColumns * kPitch, kRows*(kSide + 1)};
};

}  // namespace thinbench::five_by_five
