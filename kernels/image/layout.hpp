// The padding of rows in memory: one rule for every image type.
#pragma once

#include "image/byte_image.hpp"

namespace thinbench::detail {

[[nodiscard]] constexpr Index round_up(Index value, Index multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

/// The stride in bytes of rows of `bytes` bytes: whole cache lines, and never a multiple of 4096
/// bytes, at which every row would fall into the same cache sets.
[[nodiscard]] constexpr Index padded_row_bytes(Index bytes) {
  constexpr Index line = static_cast<Index>(kAlignment);
  const Index padded = round_up(bytes, line);
  return padded > 0 && padded % 4096 == 0 ? padded + line : padded;
}

}  // namespace thinbench::detail
