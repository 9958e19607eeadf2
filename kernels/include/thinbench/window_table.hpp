// Tables of functions of the 3 x 3 window of a pixel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "thinbench/containers.hpp"

namespace thinbench {

/// The new value of a pixel for each of the 512 values of its 3 x 3 window. Bit k of a window is
/// its pixel k in raster order:
///     0 1 2      bit 0 is the north-west neighbour, bit 4 the pixel itself,
///     3 4 5      bit 8 the south-east neighbour; foreground is 1
///     6 7 8
struct WindowTable {
  static constexpr std::size_t kWindows = 512;
  static constexpr std::size_t kCentre = 4;  // the bit of the pixel itself

  std::array<std::uint64_t, kWindows / 64> words{};  // window w is bit w % 64 of word w / 64

  [[nodiscard]] constexpr bool operator[](std::size_t window) const {
    return (words[window / 64] >> (window % 64) & 1) != 0;
  }
  constexpr void set(std::size_t window, bool value) {
    const std::uint64_t bit = std::uint64_t{1} << (window % 64);
    words[window / 64] = value ? words[window / 64] | bit : words[window / 64] & ~bit;
  }
  friend constexpr bool operator==(const WindowTable&, const WindowTable&) = default;
};

/// The table of `next(window)`, which returns true for foreground.
template <class Next>
[[nodiscard]] constexpr WindowTable make_window_table(const Next& next) {
  WindowTable table;
  for (std::size_t window = 0; window < WindowTable::kWindows; ++window) {
    table.set(window, static_cast<bool>(next(window)));
  }
  return table;
}

}  // namespace thinbench
