// The reference's arithmetic in a form that compilers vectorise: rows without branches, border
// columns separately. Compiled per ISA at -O3: the baseline for hand-written SIMD. Each pixel
// takes 9 (or 25) loads; rows share no sums.
#include "techniques/autovec_edges.hpp"

#include "core/exported.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

struct EdgeGradient {
  int gx;
  int gy;
};

template <EdgeOperator op>
inline constexpr Index kEdgeReach = op == EdgeOperator::mero_vassy_5x5 ? 2 : 1;

template <class At>
[[gnu::always_inline]] inline EdgeGradient weighted_gradient(const At& at, int middle) {
  return {at(1, -1) + middle * at(1, 0) + at(1, 1) - at(-1, -1) - middle * at(-1, 0) - at(-1, 1),
          at(-1, 1) + middle * at(0, 1) + at(1, 1) - at(-1, -1) - middle * at(0, -1) - at(1, -1)};
}

/// The sum on one side of a diagonal minus the sum on the other side; `fall` is 1 for the diagonal
/// that falls to the right, -1 for the one that rises.
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

/// `at(right, down)` returns a grey level of the window.
template <EdgeOperator op, class At>
[[gnu::always_inline]] inline EdgeGradient edge_gradient(const At& at) {
  constexpr int reach = static_cast<int>(kEdgeReach<op>);
  if constexpr (op == EdgeOperator::roberts4) {
    return {at(0, 0) - at(1, 1), at(1, 0) - at(0, 1)};
  } else if constexpr (op == EdgeOperator::roberts9) {
    return {at(-1, -1) - at(1, 1), at(1, -1) - at(-1, 1)};
  } else if constexpr (op == EdgeOperator::sobel) {
    return weighted_gradient(at, 2);
  } else if constexpr (op == EdgeOperator::prewitt) {
    return weighted_gradient(at, 1);
  } else {
    return {diagonal_difference<reach>(at, 1), diagonal_difference<reach>(at, -1)};
  }
}

/// `gradient_threshold` is already multiplied by the operator's scale.
template <EdgeOperator op, class At>
[[gnu::always_inline]] inline std::uint8_t decide(const At& at, int gradient_threshold,
                                                  int brightness_threshold) {
  const EdgeGradient gradient = edge_gradient<op>(at);
  const int gx = gradient.gx < 0 ? -gradient.gx : gradient.gx;
  const int gy = gradient.gy < 0 ? -gradient.gy : gradient.gy;
  int brightest = 0;
  for (int down = -1; down <= 1; ++down) {
    for (int right = -1; right <= 1; ++right) {
      const int grey = at(right, down);
      brightest = grey > brightest ? grey : brightest;
    }
  }
  const bool steep = gx + gy > gradient_threshold;
  const bool bright = brightest > brightness_threshold;
  return static_cast<std::uint8_t>(-static_cast<int>(steep & bright));
}

/// The nearest coordinate inside the image.
[[gnu::always_inline]] inline Index nearest(Index coordinate, Index size) {
  return coordinate < 0 ? 0 : coordinate < size ? coordinate : size - 1;
}

/// The rows of a window; rows outside the image are replaced by the nearest one inside.
template <Index reach>
struct EdgeWindow {
  const std::uint8_t* rows[static_cast<std::size_t>(2 * reach + 1)];

  EdgeWindow(const ConstImageView& image, Index y) : rows() {
    for (Index down = -reach; down <= reach; ++down) {
      rows[reach + down] = image.row(nearest(y + down, image.height));
    }
  }
};

template <EdgeOperator op>
void row_of_edges(const EdgeWindow<kEdgeReach<op>>& window, std::uint8_t* __restrict target,
                  Index width, int gradient_threshold, int brightness_threshold) {
  constexpr Index reach = kEdgeReach<op>;
  const EdgeWindow<reach> rows = window;
  const auto at_border = [&](Index x) {
    target[x] = decide<op>(
        [&](int right, int down) -> int {
          return rows.rows[reach + down][nearest(x + right, width)];
        },
        gradient_threshold, brightness_threshold);
  };
  for (Index x = 0; x < reach && x < width; ++x) at_border(x);
  for (Index x = reach; x < width - reach; ++x) {
    target[x] = decide<op>(
        [&](int right, int down) __attribute__((always_inline))->int {
          return rows.rows[reach + down][x + right];
        },
        gradient_threshold, brightness_threshold);
  }
  for (Index x = width - reach < reach ? reach : width - reach; x < width; ++x) at_border(x);
}

template <EdgeOperator op>
void edges(const EdgeThresholds& thresholds, const ConstImageView& source, const ImageView& target,
           const EdgeRows& rows) {
  const int gradient_threshold = thresholds.gradient_threshold * edge_scale(op);
  const int brightness_threshold = thresholds.brightness_threshold;
  for (Index y = rows.first; y < rows.last; ++y) {
    row_of_edges<op>(EdgeWindow<kEdgeReach<op>>(source, y), target.row(y), source.width,
                     gradient_threshold, brightness_threshold);
  }
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const AutovecEdgeKernels Exported<AutovecEdgeKernels, Isa::THINBENCH_ISA>::kKernels = {
    {{&edges<EdgeOperator::roberts4>, &edges<EdgeOperator::roberts9>,
      &edges<EdgeOperator::mero_vassy>, &edges<EdgeOperator::mero_vassy_5x5>,
      &edges<EdgeOperator::sobel>, &edges<EdgeOperator::prewitt>}}};

}  // namespace thinbench::detail
