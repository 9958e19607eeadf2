// Pixel noise from integers only, the same on every machine.
#pragma once

#include <cstdint>

#include "scene/integer_math.hpp"

namespace thinbench::scene_detail {

/// Output number `index` of the generator splitmix64 that starts from `seed`.
[[nodiscard]] constexpr std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15u * (index + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// Nearly normal noise in the unit of `sigma`: the eight bytes of one random number, added and
/// scaled. Its mean is 0, and it never leaves +- 4.9 sigma.
[[nodiscard]] constexpr std::int64_t noise_from(std::uint64_t random, std::int64_t sigma) {
  // Eight uniform bytes add up to 8 * 127.5 on average, with variance 8 * (256^2 - 1) / 12 = 209^2.
  constexpr std::int64_t kMean = 1020;
  constexpr std::int64_t kDeviation = 209;
  std::int64_t sum = 0;
  for (int shift = 0; shift < 64; shift += 8) {
    sum += static_cast<std::int64_t>((random >> shift) & 0xFFu);
  }
  return round_div((sum - kMean) * sigma, kDeviation);
}

}  // namespace thinbench::scene_detail
