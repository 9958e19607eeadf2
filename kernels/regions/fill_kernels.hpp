// The kernels that fill holes.
#pragma once

#include "core/exported.hpp"
#include "core/plane_view.hpp"

namespace thinbench::detail {

/// The flood gives up after this many visits of rows for each row.
inline constexpr Index kMaxFloodVisits = 8;

/// Sets all pixels of `filled` but those of the background that is connected to the outside.
/// `filled` has the size of the image, which has pixels. Returns false, with `filled` of no use, if
/// that takes more than about kMaxFloodVisits.
using FloodBackground = bool (*)(const ConstBitPlaneView& image, const BitPlaneView& filled);

struct FloodKernels {
  FloodBackground four;  // the background is 4-connected, as objects are 8-connected
  FloodBackground eight;
};
template <>
inline constexpr Features kGainsFrom<FloodKernels> = feature("bmi2") | feature("avx512bw") |
                                                     feature("gfni");

}  // namespace thinbench::detail
