// The kernels of the edge operators, and the tables through which the catalogue reaches them.
#pragma once

#include "dispatch/isa.hpp"
#include "image/plane_view.hpp"
#include "edges/thresholds.hpp"

namespace thinbench::detail {

/// The order of every table of edge kernels.
enum class EdgeOperator : std::uint8_t {
  roberts4,
  roberts9,
  mero_vassy,
  mero_vassy_5x5,
  sobel,
  prewitt,
};
inline constexpr int kEdgeOperators = 6;

/// What a scaled gradient is divided by; kernels multiply P1 by it instead.
[[nodiscard]] constexpr int edge_scale(EdgeOperator op) {
  constexpr int scales[kEdgeOperators] = {2, 2, 4, 12, 4, 3};
  return scales[static_cast<int>(op)];
}

/// The tables of the technique lut, see lut.cpp.
struct EdgeTables;

struct EdgeSetting {
  EdgeThresholds thresholds;
  const EdgeTables* tables = nullptr;  // for lut only
};

/// A band of rows.
struct EdgeRows {
  Index first;
  Index last;  // after the last
};

/// Writes the rows of the band in `target`, 255 where there is an edge and 0 elsewhere. Reads rows
/// beside the band, but nothing outside the source. Sizes are equal; the images do not overlap.
using EdgesToBytes = void (*)(const EdgeSetting& setting, const ConstImageView& source,
                              const ImageView& target, const EdgeRows& rows);

/// The same into packed bits; margins and the bits past the width stay 0.
using EdgesToBits = void (*)(const EdgeSetting& setting, const ConstImageView& source,
                             const BitPlaneView& target, const EdgeRows& rows);

/// The kernels of one technique by operator; nullptr where it has none.
template <class Kernel>
struct EdgeTable {
  Kernel kernels[kEdgeOperators];

  [[nodiscard]] constexpr Kernel operator[](EdgeOperator op) const {
    return kernels[static_cast<int>(op)];
  }
};

struct ScalarEdges {
  static const EdgeTable<EdgesToBytes> kLut;
};

/// Compiled once for every instruction-set level.
template <Isa isa>
struct IsaEdges {
  static const EdgeTable<EdgesToBytes> kAutovec;
  static const EdgeTable<EdgesToBytes> kSimd16Bit;
  static const EdgeTable<EdgesToBytes> kSimd8Bit;
  static const EdgeTable<EdgesToBits> kSimdToBits;
};

}  // namespace thinbench::detail
