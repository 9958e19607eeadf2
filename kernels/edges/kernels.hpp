// The kernels of the edge operators, in tables by operator.
#pragma once

#include "core/exported.hpp"
#include "core/plane_view.hpp"
#include "thinbench/edges.hpp"

namespace thinbench::detail {

/// What edges gain from.
inline constexpr Features kEdgeFeatures =
    feature("sse4.2") | feature("avx2") | feature("avx512bw") | feature("sha3");

/// The operator's scale: kernels multiply the gradient threshold by it.
[[nodiscard]] constexpr int edge_scale(EdgeOperator op) {
  constexpr int scales[kEdgeOperators.size()] = {2, 2, 4, 12, 4, 3};
  return scales[static_cast<std::size_t>(op)];
}

/// The band of rows [first, last).
struct EdgeRows {
  Index first;
  Index last;
};

/// Writes the rows of the band: 255 on edges, else 0. Also reads adjacent rows of the source. Both
/// images have the same size and do not overlap.
using EdgesToBytes = void (*)(const EdgeThresholds& thresholds, const ConstImageView& source,
                              const ImageView& target, const EdgeRows& rows);

/// The same as packed bits. Leaves margins and the bits past the width 0.
using EdgesToBits = void (*)(const EdgeThresholds& thresholds, const ConstImageView& source,
                             const BitPlaneView& target, const EdgeRows& rows);

/// The kernels of one technique by operator; nullptr where there is none.
template <class Kernel>
struct EdgeTable {
  Kernel kernels[kEdgeOperators.size()];

  [[nodiscard]] constexpr Kernel operator[](EdgeOperator op) const {
    return kernels[static_cast<std::size_t>(op)];
  }
};

struct EdgeKernels {
  EdgeTable<EdgesToBytes> simd_16bit;
  EdgeTable<EdgesToBytes> simd_8bit;
  EdgeTable<EdgesToBits> to_bits;
};
template <>
inline constexpr Features kGainsFrom<EdgeKernels> = kEdgeFeatures;

}  // namespace thinbench::detail
