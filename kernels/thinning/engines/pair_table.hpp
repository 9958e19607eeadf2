// The table of lut_sliding: two new pixels by window of four columns.
#pragma once

#include <cstddef>
#include <cstdint>

namespace thinbench::detail {

inline constexpr std::size_t kPairTableSize = 4096;

/// `pairs[window]` holds the new pixels in the middle of columns 1 and 2, one per byte. Column c of
/// the window is its bits 3 c to 3 c + 2, south first. The index of `new_pixel` is k + 256 p, with
/// the descriptor k.
constexpr void fill_pair_table(const std::uint8_t* new_pixel, std::uint16_t* pairs) {
  // Bit i of three adjacent columns is bit bit_of[i] of k + 256 p.
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

}  // namespace thinbench::detail
