// The edge operators on single pixels, as the techniques that go pixel by pixel need them.
// `at(right, down)` is a grey level of the window as an int.
#pragma once

#include "edges/kernels.hpp"

namespace thinbench::detail {

struct EdgeGradient {
  int gx;
  int gy;
};

template <EdgeOperator op>
inline constexpr Index kEdgeReach = op == EdgeOperator::mero_vassy_5x5 ? 2 : 1;

namespace internal {

template <class At>
[[gnu::always_inline]] inline EdgeGradient weighted_gradient(const At& at, int middle) {
  return {at(1, -1) + middle * at(1, 0) + at(1, 1) - at(-1, -1) - middle * at(-1, 0) - at(-1, 1),
          at(-1, 1) + middle * at(0, 1) + at(1, 1) - at(-1, -1) - middle * at(0, -1) - at(1, -1)};
}

/// What lies on one side of a diagonal counts in full, on the other side negatively; `fall` is 1
/// for the diagonal that falls to the right, -1 for the one that rises.
template <int reach, class At>
[[gnu::always_inline]] inline int diagonal_difference(const At& at, int fall) {
  int total = 0;
  for (int down = -reach; down <= reach; ++down) {
    for (int right = -reach; right <= reach; ++right) {
      const int side = right - fall * down;
      total += side > 0 ? at(right, down) : side < 0 ? -at(right, down) : 0;
    }
  }
  return total;
}

}  // namespace internal

template <EdgeOperator op, class At>
[[gnu::always_inline]] inline EdgeGradient edge_gradient(const At& at) {
  constexpr int reach = static_cast<int>(kEdgeReach<op>);
  if constexpr (op == EdgeOperator::roberts4) {
    return {at(0, 0) - at(1, 1), at(1, 0) - at(0, 1)};
  } else if constexpr (op == EdgeOperator::roberts9) {
    return {at(-1, -1) - at(1, 1), at(1, -1) - at(-1, 1)};
  } else if constexpr (op == EdgeOperator::sobel) {
    return internal::weighted_gradient(at, 2);
  } else if constexpr (op == EdgeOperator::prewitt) {
    return internal::weighted_gradient(at, 1);
  } else {
    return {internal::diagonal_difference<reach>(at, 1), internal::diagonal_difference<reach>(at, -1)};
  }
}

/// Pointers to the rows of a window; rows outside the image are the nearest inside.
template <Index reach>
struct EdgeWindow {
  const std::uint8_t* rows[static_cast<std::size_t>(2 * reach + 1)];

  EdgeWindow(const ConstImageView& image, Index y) : rows() {
    for (Index down = -reach; down <= reach; ++down) {
      const Index row = y + down;
      rows[reach + down] = image.row(row < 0 ? 0 : row < image.height ? row : image.height - 1);
    }
  }
};

/// Column x, or the nearest inside the image.
[[nodiscard]] constexpr Index nearest_column(Index x, Index width) {
  return x < 0 ? 0 : x < width ? x : width - 1;
}

}  // namespace thinbench::detail
