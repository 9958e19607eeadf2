// Windows of 3 x 3 pixels as nine bits: symmetries and patterns.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "thinbench/window_table.hpp"

namespace thinbench::detail {

inline constexpr std::size_t kCentreBit = std::size_t{1} << WindowTable::kCentre;
inline constexpr std::size_t kRingBits = WindowTable::kWindows - 1 - kCentreBit;

constexpr bool pixel_of(std::size_t window, std::size_t k) {
  return (window >> k & 1) != 0;
}

/// Pixel k of the result is pixel `from[k]` of the window.
using Permutation = std::array<std::size_t, 9>;
inline constexpr Permutation kRotateBy90 = {6, 3, 0, 7, 4, 1, 8, 5, 2};  // clockwise
inline constexpr Permutation kRotateBy45 = {3, 0, 1, 6, 4, 2, 7, 8, 5};  // the ring, clockwise
inline constexpr Permutation kMirror = {2, 1, 0, 5, 4, 3, 8, 7, 6};      // west and east exchanged

constexpr std::size_t permuted(std::size_t window, const Permutation& from) {
  std::size_t result = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (pixel_of(window, from[k])) result |= std::size_t{1} << k;
  }
  return result;
}

/// The pixels that a window must have: a hit-or-miss structuring element.
struct WindowPattern {
  std::size_t foreground = 0;
  std::size_t background = 0;

  [[nodiscard]] constexpr bool matches(std::size_t window) const {
    return (window & foreground) == foreground && (window & background) == 0;
  }
};

constexpr WindowPattern permuted(const WindowPattern& pattern, const Permutation& from) {
  return {permuted(pattern.foreground, from), permuted(pattern.background, from)};
}

/// Pixels in raster order, 1 and 0, anything else for either; spaces are skipped.
constexpr WindowPattern pattern_of(std::string_view text) {
  WindowPattern pattern;
  std::size_t bit = 1;
  for (const char symbol : text) {
    if (symbol == ' ') continue;
    if (symbol == '1') pattern.foreground |= bit;
    if (symbol == '0') pattern.background |= bit;
    bit <<= 1;
  }
  return pattern;
}

}  // namespace thinbench::detail
