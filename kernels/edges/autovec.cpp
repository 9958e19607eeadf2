// The reference's arithmetic in a form that compilers vectorise: whole rows without a branch, the
// columns at the frame apart. Compiled once for every instruction-set level at -O3, so that
// hand-written SIMD is compared with what the compiler gives for free. Every pixel of the window is
// loaded anew: 9 (or 25) loads a pixel and all sums again for each row.
#include "dispatch/exported.hpp"
#include "edges/operators.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <EdgeOperator op, class At>
[[gnu::always_inline]] inline std::uint8_t decide(const At& at, int threshold, int p2) {
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
  const bool above_p1 = gx + gy > threshold;
  const bool above_p2 = brightest > p2;
  return static_cast<std::uint8_t>(-static_cast<int>(above_p1 & above_p2));
}

template <EdgeOperator op>
void row_of_edges(const EdgeWindow<kEdgeReach<op>>& window, std::uint8_t* __restrict target,
                  Index width, int threshold, int p2) {
  constexpr Index reach = kEdgeReach<op>;
  const EdgeWindow<reach> rows = window;
  const auto at_frame = [&](Index x) {
    target[x] = decide<op>(
        [&](int right, int down) -> int {
          return rows.rows[reach + down][nearest_column(x + right, width)];
        },
        threshold, p2);
  };
  for (Index x = 0; x < reach && x < width; ++x) at_frame(x);
  for (Index x = reach; x < width - reach; ++x) {
    target[x] = decide<op>(
        [&](int right, int down) __attribute__((always_inline))->int {
          return rows.rows[reach + down][x + right];
        },
        threshold, p2);
  }
  for (Index x = width - reach < reach ? reach : width - reach; x < width; ++x) at_frame(x);
}

template <EdgeOperator op>
void edges(const EdgeThresholds& thresholds, const ConstImageView& source, const ImageView& target,
           const EdgeRows& rows) {
  const int threshold = thresholds.gradient_threshold * edge_scale(op);
  const int p2 = thresholds.brightness_threshold;
  for (Index y = rows.first; y < rows.last; ++y) {
    row_of_edges<op>(EdgeWindow<kEdgeReach<op>>(source, y), target.row(y), source.width, threshold,
                     p2);
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
