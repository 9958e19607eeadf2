// Bands of rows, the parts of planes that are skipped where nothing changes. Plain data, safe to
// include in files of every ISA.
#pragma once

#include "core/plane_view.hpp"

namespace thinbench::detail {

/// A band of rows, divided into at most 64 columns of `column_elements` elements. Column i is
/// active, and must be computed, if bit i of `columns` is set.
struct Band {
  Index first;  // row
  Index last;   // row after the last
  std::uint64_t columns;
  Index column_elements;
  Index row_elements;  // the last column may be narrower than the others

  /// The bit set of columns that contain elements [from, to).
  [[nodiscard]] std::uint64_t columns_of(Index from, Index to) const {
    const Index low = from / column_elements;
    const Index high = (to - 1) / column_elements;
    return (~std::uint64_t{0} >> (63 - (high - low))) << low;
  }
};

}  // namespace thinbench::detail
