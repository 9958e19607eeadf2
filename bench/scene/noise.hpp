// Pixel noise from integers only, the same on every machine.
#pragma once

#include <cstdint>

#include "scene/integer_math.hpp"

namespace thinbench::scene_detail {

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
