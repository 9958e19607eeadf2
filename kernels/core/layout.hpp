// The padding of rows in memory, for all image types.
#pragma once

#include "core/byte_image.hpp"

namespace thinbench::detail {

[[nodiscard]] constexpr Index round_up(Index value, Index multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

/// The stride, in bytes, for rows of `bytes` bytes: whole cache lines, but never a multiple of 4096
/// bytes, which would map all rows to the same cache sets.
[[nodiscard]] constexpr Index padded_row_bytes(Index bytes) {
  constexpr Index line = static_cast<Index>(kAlignment);
  const Index padded = round_up(bytes, line);
  return padded > 0 && padded % 4096 == 0 ? padded + line : padded;
}

}  // namespace thinbench::detail
