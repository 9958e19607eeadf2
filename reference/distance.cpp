#include "thinbench/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference.hpp"

namespace thinbench::reference {
namespace {

constexpr Index kNone = -1;

/// The distance to the nearest background pixel of the same column, or kNone.
Index distance_in_column(const ConstImageView& source, Index x, Index y) {
  for (Index d = 0; d < source.height; ++d) {
    if (y - d >= 0 && source.row(y - d)[x] == 0) return d;
    if (y + d < source.height && source.row(y + d)[x] == 0) return d;
  }
  return kNone;
}

/// From the nearest column outwards, until the columns alone are too far away.
Index squared_distance(const std::vector<Index>& in_column, Index x) {
  const Index width = static_cast<Index>(in_column.size());
  Index lowest = kNoBackground;
  for (Index d = 0; d < width && d * d < lowest; ++d) {
    for (const Index u : {x - d, x + d}) {
      if (u < 0 || u >= width) continue;
      const Index vertical = in_column[static_cast<std::size_t>(u)];
      if (vertical != kNone) lowest = std::min(lowest, d * d + vertical * vertical);
    }
  }
  return lowest;
}

}  // namespace

void squared_distances(ConstImageView source, LabelView distances) {
  for (Index y = 0; y < source.height; ++y) {
    std::vector<Index> in_column;
    for (Index x = 0; x < source.width; ++x) in_column.push_back(distance_in_column(source, x, y));
    for (Index x = 0; x < source.width; ++x) {
      distances.row(y)[x] = static_cast<std::int32_t>(squared_distance(in_column, x));
    }
  }
}

void distances(ConstImageView source, View<double> distances, const Spacing& spacing) {
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      double lowest = std::numeric_limits<double>::infinity();
      for (Index v = 0; v < source.height; ++v) {
        for (Index u = 0; u < source.width; ++u) {
          const double down = static_cast<double>(y - v) * spacing.y;
          const double across = static_cast<double>(x - u) * spacing.x;
          if (source.row(v)[u] == 0) lowest = std::min(lowest, down * down + across * across);
        }
      }
      distances.row(y)[x] = std::sqrt(lowest);
    }
  }
}

}  // namespace thinbench::reference
