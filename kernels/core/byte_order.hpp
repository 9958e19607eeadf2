// Bytes in memory as words and back, on machines of both byte orders.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "thinbench/image_view.hpp"

namespace thinbench::detail {

/// The first byte becomes the lowest. Its own inverse.
inline std::uint64_t first_byte_lowest(std::uint64_t word) {
  if constexpr (std::endian::native == std::endian::big) return __builtin_bswap64(word);
  return word;
}

/// The first of up to eight bytes is the lowest of the word; those that are missing are 0.
inline std::uint64_t load_bytes(const std::uint8_t* from, std::size_t count = 8) {
  std::uint64_t word = 0;
  std::memcpy(&word, from, count);
  return first_byte_lowest(word);
}

/// The reverse: writes the lowest `count` bytes.
inline void store_bytes(std::uint8_t* to, std::uint64_t word, std::size_t count = 8) {
  word = first_byte_lowest(word);
  std::memcpy(to, &word, count);
}

}  // namespace thinbench::detail
