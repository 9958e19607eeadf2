// Processor features, of which instruction sets are sets.
#pragma once

#include <cstdint>

namespace thinbench::detail {

enum class Features : std::uint32_t {
  none = 0,
  sse4_2 = 1U << 0,
  popcnt = 1U << 1,
  avx2 = 1U << 2,
  bmi = 1U << 3,
  bmi2 = 1U << 4,
  avx512f = 1U << 5,
  avx512cd = 1U << 6,
  avx512dq = 1U << 7,
  avx512bw = 1U << 8,
  avx512vl = 1U << 9,
  avx512vbmi = 1U << 10,
  avx512vbmi2 = 1U << 11,
  avx512vnni = 1U << 12,
  avx512bitalg = 1U << 13,
  avx512vpopcntdq = 1U << 14,
  gfni = 1U << 15,
};

constexpr Features operator|(Features a, Features b) {
  return static_cast<Features>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}

/// Whether every feature of `wanted` is in `set`.
constexpr bool contains(Features set, Features wanted) {
  return (static_cast<std::uint32_t>(wanted) & ~static_cast<std::uint32_t>(set)) == 0;
}

/// The features that processor and operating system support.
[[nodiscard]] Features detect_features();

}  // namespace thinbench::detail
