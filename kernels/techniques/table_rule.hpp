// Tables for the techniques with look-up tables. Plain data, so that files of every ISA can include
// it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace thinbench::detail {

inline constexpr std::size_t kPairTableSize = 4096;

/// The table of lut_sliding: `pairs[window]` holds the two new pixels at the centre of a window of
/// four columns and three rows, one per byte. Bits 3 c to 3 c + 2 of the window are its column c,
/// south first. `new_pixel` is indexed by k + 256 p, with the descriptor k.
constexpr void fill_pair_table(const std::uint8_t* new_pixel, std::uint16_t* pairs) {
  // Maps bit i of three adjacent columns to bit bit_of[i] of k + 256 p.
  constexpr int bit_of[9] = {5, 4, 3, 6, 8, 2, 7, 0, 1};
  const auto pixel = [&](std::size_t columns) {
    std::size_t index = 0;
    for (std::size_t bit = 0; bit < 9; ++bit) index |= (columns >> bit & 1) << bit_of[bit];
    return new_pixel[index];
  };
  for (std::size_t window = 0; window < kPairTableSize; ++window) {
    pairs[window] = static_cast<std::uint16_t>(pixel(window & 511) | pixel(window >> 3) << 8);
  }
}

/// A rule of one sub-iteration that only removes pixels, for the techniques with look-up tables.
struct TableRule {
  std::uint8_t new_pixel[512];  // by k + 256 p, with the descriptor k; 0 or 1
  std::uint16_t pixel_pairs[kPairTableSize];
};

}  // namespace thinbench::detail
