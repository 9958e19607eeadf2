// Hashes of images and numbers in the golden file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/fnv1a.hpp"

namespace thinbench::golden {

/// The first 8 digits of the hash: 32 bits tell a wrong output, too.
inline std::string digits_of(const Fnv1a& hash) {
  return hash.text().substr(0, 8);
}

/// Hashes width, height and pixels.
inline std::string hash_of(const ByteImage& image) {
  Fnv1a hash;
  hash.add_number(image.width());
  hash.add_number(image.height());
  hash.add_pixels(image.view());
  return digits_of(hash);
}

inline std::string hash_of(const std::vector<std::int64_t>& numbers) {
  Fnv1a hash;
  for (const std::int64_t number : numbers) hash.add_number(number);
  return digits_of(hash);
}

}  // namespace thinbench::golden
