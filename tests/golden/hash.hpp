// 64-bit FNV-1a of images and numbers, the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "support/byte_image.hpp"

namespace thinbench::golden {

class Fnv1a {
 public:
  void add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001B3; }

  /// Eight bytes, the lowest first.
  void add_number(std::int64_t number) {
    const auto bits = static_cast<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<std::uint8_t>(bits >> shift));
  }

  /// 16 hexadecimal digits.
  [[nodiscard]] std::string text() const {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash_));
    return text.data();
  }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

/// Of width and height as numbers, and then the pixels row by row.
inline std::string hash_of(const ByteImage& image) {
  Fnv1a hash;
  hash.add_number(image.width());
  hash.add_number(image.height());
  for (Index y = 0; y < image.height(); ++y) {
    for (Index x = 0; x < image.width(); ++x) hash.add(image.at(x, y));
  }
  return hash.text();
}

inline std::string hash_of(const std::vector<std::int64_t>& numbers) {
  Fnv1a hash;
  for (const std::int64_t number : numbers) hash.add_number(number);
  return hash.text();
}

}  // namespace thinbench::golden
