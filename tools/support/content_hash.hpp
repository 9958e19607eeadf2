// A hash of bytes that tells damage and other contents, not attacks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include <fmt/format.h>

namespace thinbench {

/// Each step is a bijection of the hash, so a change of eight bytes or fewer is always seen.
inline std::uint64_t with_word(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15;
  return hash ^ hash >> 32;
}

/// About 5 bytes per nanosecond. `hash` is that of what came before.
inline std::uint64_t hash_of(const void* bytes, std::size_t count, std::uint64_t hash = 0) {
  const auto* const from = static_cast<const char*>(bytes);
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, from + i, 8);
    hash = with_word(hash, word);
  }
  std::uint64_t last = 0;
  if (i < count) std::memcpy(&last, from + i, count - i);
  return with_word(with_word(hash, last), count);
}

/// 16 hexadecimal digits.
inline std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace thinbench
