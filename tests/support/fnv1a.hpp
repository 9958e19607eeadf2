// The 64-bit FNV-1a hash, the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include "support/byte_image.hpp"

namespace thinbench {

class Fnv1a {
 public:
  void add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001B3; }

  /// Eight bytes, little-endian.
  void add_number(std::int64_t number) {
    const auto bits = static_cast<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<std::uint8_t>(bits >> shift));
  }

  /// The pixels in raster order, without padding.
  void add_pixels(const ConstImageView& view) {
    for (Index y = 0; y < view.height; ++y) {
      for (Index x = 0; x < view.width; ++x) add(view.row(y)[x]);
    }
  }

  [[nodiscard]] std::uint64_t value() const { return hash_; }

  /// 16 hexadecimal digits.
  [[nodiscard]] std::string text() const {
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash_));
    return text.data();
  }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325;
};

}  // namespace thinbench
