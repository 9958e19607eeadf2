// Pixels against the means of the windows around them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "thinbench/binarise.hpp"

namespace thinbench::detail {

/// The window's side, for an image of this size.
[[nodiscard]] inline int window_of(const LocalThreshold& local, Index width, Index height) {
  constexpr Index min = 15, max = 65535;
  if (local.window != 0) return local.window;
  return static_cast<int>(std::clamp(std::min(width, height) / 8, min, max) | 1);
}

/// Visits an image from top to bottom with the sum of each pixel's window. Takes a row of sums.
template <class T>
class LocalMeans {
 public:
  LocalMeans(const View<const T>& grey, int window)
      : grey_(grey), reach_(window / 2), sums_(static_cast<std::size_t>(grey.width)) {
    for (Index y = 0; y < std::min(reach_, grey_.height); ++y) add_row(y, 1);
  }

  /// Calls visit(x, level, sum, pixels) for all pixels of row `y`, which follows the row before.
  template <class Visit>
  void visit_row(Index y, const Visit& visit) {
    const Index rows = move_to(y);
    const T* const row = grey_.row(y);
    std::int64_t sum = 0;
    for (Index x = 0; x < std::min(reach_, grey_.width); ++x) sum += sums_[index(x)];
    for (Index x = 0; x < grey_.width; ++x) {
      if (x + reach_ < grey_.width) sum += sums_[index(x + reach_)];
      if (x > reach_) sum -= sums_[index(x - reach_ - 1)];
      const Index columns =
          std::min(x + reach_, grey_.width - 1) - std::max<Index>(x - reach_, 0) + 1;
      visit(x, Index{row[x]}, sum, rows * columns);
    }
  }

 private:
  static std::size_t index(Index x) { return static_cast<std::size_t>(x); }
  /// Makes the sums of columns those of the window around row `y`; returns its rows.
  Index move_to(Index y) {
    if (y + reach_ < grey_.height) add_row(y + reach_, 1);
    if (y > reach_) add_row(y - reach_ - 1, -1);
    return std::min(y + reach_, grey_.height - 1) - std::max<Index>(y - reach_, 0) + 1;
  }
  void add_row(Index y, int sign) {
    const T* const row = grey_.row(y);
    for (Index x = 0; x < grey_.width; ++x) sums_[index(x)] += sign * row[x];
  }

  View<const T> grey_;
  Index reach_;
  std::vector<std::int64_t> sums_;  // of columns
};

}  // namespace thinbench::detail
