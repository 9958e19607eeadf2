// The two thresholds of section 2.1.
#pragma once

namespace thinbench::detail {

/// In grey levels, both from 0 to 255. An edge needs a scaled gradient bigger than `p1` and a pixel
/// brighter than `p2` in its 3 x 3 neighbourhood: the background is the bright side.
struct EdgeThresholds {
  int p1 = 40;
  int p2 = 128;
};

inline constexpr int kLargestThreshold = 255;

}  // namespace thinbench::detail
