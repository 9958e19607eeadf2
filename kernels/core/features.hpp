// Features of processors that instruction sets need.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

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

/// Those of an ISA.
[[nodiscard]] Features features_of(Isa isa);

[[nodiscard]] inline bool has(Isa isa, Features features) {
  return (features & ~features_of(isa)) == 0;
}

/// The ISAs that add one of these features to those before them, and the baseline: for kernels that
/// use no others.
[[nodiscard]] std::vector<Isa> isas_with(Features used);

/// What processor and operating system support: the latter must save AVX and AVX-512 registers.
[[nodiscard]] Features detect_features();

}  // namespace thinbench::detail
