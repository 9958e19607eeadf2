// Features of processors that instruction sets need.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "thinbench/isa.hpp"

namespace thinbench::detail {

/// A set of features: bit i stands for kFeatureNames[i].
using Features = std::uint32_t;

inline constexpr std::array<std::string_view, 17> kFeatureNames = {
    "sse4.2",     "popcnt",      "avx2",       "bmi",          "bmi2",
    "avx512f",    "avx512cd",    "avx512dq",   "avx512bw",     "avx512vl",
    "avx512vbmi", "avx512vbmi2", "avx512vnni", "avx512bitalg", "avx512vpopcntdq",
    "gfni",       "sha3"};

/// The set of one feature. `name` must be one of kFeatureNames.
consteval Features feature(std::string_view name) {
  std::size_t i = 0;
  while (kFeatureNames.at(i) != name) ++i;
  return Features{1} << i;
}

inline constexpr Features kSse42 = feature("sse4.2") | feature("popcnt");
inline constexpr Features kAvx2 = kSse42 | feature("avx2") | feature("bmi") | feature("bmi2");
inline constexpr Features kAvx512 = kAvx2 | feature("avx512f") | feature("avx512cd") |
                                    feature("avx512dq") | feature("avx512bw") | feature("avx512vl");
inline constexpr Features kAvx512Icl = kAvx512 | feature("avx512vbmi") | feature("avx512vbmi2") |
                                       feature("avx512vnni") | feature("avx512bitalg") |
                                       feature("avx512vpopcntdq") | feature("gfni");

/// What an ISA needs.
[[nodiscard]] constexpr Features features_of(Isa isa) {
  constexpr Features features[] = {0, kSse42, kAvx2, kAvx512, kAvx512Icl, feature("sha3")};
  return features[static_cast<std::size_t>(isa)];
}

[[nodiscard]] constexpr bool has(Isa isa, Features features) {
  return (features & ~features_of(isa)) == 0;
}

/// What processor and operating system support: the latter must save AVX and AVX-512 registers.
[[nodiscard]] Features detect_features();

}  // namespace thinbench::detail
