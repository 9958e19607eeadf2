#include "binarise/local_means.hpp"

#include <algorithm>

namespace thinbench::detail {

int window_of(const LocalThreshold& local, Index width, Index height) {
  constexpr Index min = 15, max = 65535;
  if (local.window != 0) return local.window;
  return static_cast<int>(std::clamp(std::min(width, height) / 8, min, max) | 1);
}

LocalMeans::LocalMeans(const ConstImageView& grey, int window)
    : grey_(grey), reach_(window / 2), sums_(static_cast<std::size_t>(grey.width)) {
  for (Index y = 0; y < std::min(reach_, grey_.height); ++y) add_row(y, 1);
}

Index LocalMeans::move_to(Index y) {
  if (y + reach_ < grey_.height) add_row(y + reach_, 1);
  if (y > reach_) add_row(y - reach_ - 1, -1);
  return std::min(y + reach_, grey_.height - 1) - std::max<Index>(y - reach_, 0) + 1;
}

void LocalMeans::add_row(Index y, int sign) {
  const std::uint8_t* const row = grey_.row(y);
  for (Index x = 0; x < grey_.width; ++x) sums_[index(x)] += sign * row[x];
}

}  // namespace thinbench::detail
