// Along columns first, then the best column of each row.
#include "experiments/distances.hpp"

#include <algorithm>

namespace thinbench {
namespace {

constexpr std::int64_t kFar = 1 << 20;

}  // namespace

Distances::Distances(const ConstImageView& marked)
    : width_(marked.width), squared_(static_cast<std::size_t>(marked.width * marked.height)) {
  std::vector<std::int64_t> along(squared_.size(), kFar);
  for (Index x = 0; x < width_; ++x) mark_column(marked, x, along);
  for (Index y = 0; y < marked.height; ++y) {
    for (Index x = 0; x < width_; ++x) squared_[place(x, y)] = nearest_column(along, x, y);
  }
}

void Distances::mark_column(const ConstImageView& marked, Index x,
                            std::vector<std::int64_t>& along) const {
  std::int64_t distance = kFar;
  const auto visit = [&](Index y) {
    distance = marked.row(y)[x] != 0 ? 0 : distance + 1;
    along[place(x, y)] = std::min(along[place(x, y)], distance);
  };
  for (Index y = 0; y < marked.height; ++y) visit(y);
  distance = kFar;
  for (Index y = marked.height - 1; y >= 0; --y) visit(y);
}

std::int64_t Distances::nearest_column(const std::vector<std::int64_t>& along, Index x,
                                       Index y) const {
  std::int64_t best = kFar * kFar;
  // Columns further away than the best so far cannot win.
  for (Index reach = 0; reach < width_ && reach * reach < best; ++reach) {
    for (const Index column : {x - reach, x + reach}) {
      if (column < 0 || column >= width_) continue;
      const std::int64_t down = along[place(column, y)];
      best = std::min(best, reach * reach + down * down);
    }
  }
  return best;
}

}  // namespace thinbench
