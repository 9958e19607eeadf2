// How many bits of a byte are set up to each of its bits, for architectures that look it up. For
// ISA files only.
#pragma once

#include <array>
#include <cstdint>

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

using PrefixCounts = std::array<std::array<std::uint8_t, 8>, 256>;

/// Element [byte][i] counts the set bits among bits 0 to i.
inline constexpr PrefixCounts kPrefixCounts = [] {
  PrefixCounts all{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    std::uint8_t count = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
      count = static_cast<std::uint8_t>(count + (byte >> bit & 1));
      all[byte][bit] = count;
    }
  }
  return all;
}();

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
