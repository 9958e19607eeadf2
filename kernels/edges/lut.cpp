// Both thresholds and the magnitudes by table, pixel by pixel, as a program of the paper's time
// would have it: 12 look-ups a pixel beside the sums (9 pixels of the window above P2, 2
// magnitudes, 1 decision). The tables take 15 KB and stay in the L1 cache. No branch depends on the
// picture, which is what it gains over plain code.
#include "edges/operators.hpp"
#include "edges/tables.hpp"

namespace thinbench::detail {
namespace {

template <EdgeOperator op, class At>
std::uint8_t decide(const EdgeTables& tables, const At& at) {
  const EdgeGradient gradient = edge_gradient<op>(at);
  const int sum = tables.magnitude[static_cast<std::size_t>(gradient.gx + kLargestDifference)] +
                  tables.magnitude[static_cast<std::size_t>(gradient.gy + kLargestDifference)];
  unsigned bright = 0;
  for (int down = -1; down <= 1; ++down) {
    for (int right = -1; right <= 1; ++right) {
      bright |= tables.above_p2[static_cast<std::size_t>(at(right, down))];
    }
  }
  return static_cast<std::uint8_t>(bright & tables.above_p1[static_cast<std::size_t>(sum)]);
}

template <EdgeOperator op>
void edges(const EdgeSetting& setting, const ConstImageView& source, const ImageView& target,
           const EdgeRows& rows) {
  constexpr Index reach = kEdgeReach<op>;
  const Index width = source.width;
  for (Index y = rows.first; y < rows.last; ++y) {
    const EdgeWindow<reach> window(source, y);
    std::uint8_t* to = target.row(y);
    const auto pixel = [&](Index x, auto column) {
      to[x] = decide<op>(*setting.tables, [&](int right, int down) -> int {
        return window.rows[reach + down][column(x + right)];
      });
    };
    const auto nearest = [&](Index x) { return nearest_column(x, width); };
    for (Index x = 0; x < reach && x < width; ++x) pixel(x, nearest);
    for (Index x = reach; x < width - reach; ++x) pixel(x, [](Index inside) { return inside; });
    for (Index x = width - reach < reach ? reach : width - reach; x < width; ++x) pixel(x, nearest);
  }
}

}  // namespace

EdgeTables::EdgeTables(EdgeOperator op, const EdgeThresholds& thresholds)
    : magnitude(), above_p1(), above_p2() {
  const int threshold = thresholds.p1 * edge_scale(op);
  for (int i = 0; i <= 2 * kLargestDifference; ++i) {
    const auto place = static_cast<std::size_t>(i);
    const int difference = i - kLargestDifference;
    magnitude[place] = static_cast<std::int16_t>(difference < 0 ? -difference : difference);
    above_p1[place] = i > threshold ? 255 : 0;
  }
  for (int grey = 0; grey < 256; ++grey) {
    above_p2[static_cast<std::size_t>(grey)] = grey > thresholds.p2 ? 255 : 0;
  }
}

constinit const EdgeTable<EdgesToBytes> ScalarEdges::kLut = {
    {&edges<EdgeOperator::roberts4>, &edges<EdgeOperator::roberts9>,
     &edges<EdgeOperator::mero_vassy>, &edges<EdgeOperator::mero_vassy_5x5>,
     &edges<EdgeOperator::sobel>, &edges<EdgeOperator::prewitt>}};

}  // namespace thinbench::detail
