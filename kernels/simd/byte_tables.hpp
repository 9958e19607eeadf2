// Facts about the bits of each byte, for architectures that look them up. For ISA files only.
#pragma once

#include <array>
#include <cstdint>

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

using ByteTable = std::array<std::array<std::uint8_t, 8>, 256>;

/// Element [byte][i] counts the set bits among bits 0 to i.
inline constexpr ByteTable kPrefixCounts = [] {
  ByteTable all{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    std::uint8_t count = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
      count = static_cast<std::uint8_t>(count + (byte >> bit & 1));
      all[byte][bit] = count;
    }
  }
  return all;
}();

/// Element [byte][i] is the number of the i-th set bit, counted from 0.
inline constexpr ByteTable kSetBits = [] {
  ByteTable all{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned count = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
      if ((byte >> bit & 1) != 0) all[byte][count++] = static_cast<std::uint8_t>(bit);
    }
  }
  return all;
}();

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
