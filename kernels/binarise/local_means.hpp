// Pixels against the means of the windows around them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "thinbench/binarise.hpp"

namespace thinbench::detail {

/// The window's side, for an image of this size.
[[nodiscard]] int window_of(const LocalThreshold& local, Index width, Index height);

/// Visits an image from top to bottom with the sum of each pixel's window. Takes a row of sums.
class LocalMeans {
 public:
  LocalMeans(const ConstImageView& grey, int window);

  /// Calls visit(x, level, sum, pixels) for all pixels of row `y`, which follows the row before.
  template <class Visit>
  void visit_row(Index y, const Visit& visit) {
    const Index rows = move_to(y);
    const std::uint8_t* const row = grey_.row(y);
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
  Index move_to(Index y);
  void add_row(Index y, int sign);

  ConstImageView grey_;
  Index reach_;
  std::vector<std::int64_t> sums_;  // of columns
};

}  // namespace thinbench::detail
