// The tables of the technique lut: both thresholds answered for every value that can occur.
#pragma once

#include <array>
#include <cstdint>

#include "edges/kernels.hpp"

namespace thinbench::detail {

/// The largest |gx| or |gy| of any operator, and of their sum: Mero-Vassy's halves of 10 pixels.
inline constexpr int kLargestDifference = 10 * 255;

struct EdgeTables {
  EdgeTables(EdgeOperator op, const EdgeThresholds& thresholds);

  /// |d| at d + kLargestDifference.
  std::array<std::int16_t, 2 * kLargestDifference + 1> magnitude;
  /// 255 where a sum of magnitudes is above P1, 255 where a grey level is above P2; else 0.
  std::array<std::uint8_t, 2 * kLargestDifference + 1> above_p1;
  std::array<std::uint8_t, 256> above_p2;
};

}  // namespace thinbench::detail
