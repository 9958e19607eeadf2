// Exact integer helpers of the scene renderer; none of them depends on the machine's rounding.
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

}  // namespace thinbench::scene_detail
