// Exact integer helpers of the scene renderer, and pixel noise from integers only: nothing depends
// on the machine.
#pragma once

#include <cstdint>

namespace thinbench::scene_detail {

/// Quotient rounded towards minus infinity; `divisor` is positive.
[[nodiscard]] constexpr std::int64_t floor_div(std::int64_t value, std::int64_t divisor) {
  const std::int64_t quotient = value / divisor;
  return value % divisor < 0 ? quotient - 1 : quotient;
}

/// Quotient rounded to the nearest integer, halves upwards; `divisor` is positive.
[[nodiscard]] constexpr std::int64_t round_div(std::int64_t value, std::int64_t divisor) {
  return floor_div(2 * value + divisor, 2 * divisor);
}

/// Largest integer whose square is at most `value` (0 <= value < 2^62), found bit by bit by
/// comparing squares.
[[nodiscard]] constexpr std::int64_t floor_sqrt(std::int64_t value) {
  std::int64_t root = 0;
  std::int64_t bit = 1;
  while (4 * bit * bit <= value) bit *= 2;
  for (; bit > 0; bit /= 2) {
    const std::int64_t candidate = root + bit;
    if (candidate * candidate <= value) root = candidate;
  }
  return root;
}

/// Smallest integer whose square is at least `value` (0 <= value < 2^62).
[[nodiscard]] constexpr std::int64_t ceil_sqrt(std::int64_t value) {
  const std::int64_t root = floor_sqrt(value);
  return root * root == value ? root : root + 1;
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
