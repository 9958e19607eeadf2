// Exact Euclidean distances on the pixel grid.
#pragma once

#include <cstdint>
#include <vector>

#include "support/byte_image.hpp"

namespace thinbench {

/// Squared distances to the nearest marked (not 0) pixel; at least 2^40 where none is marked.
class Distances {
 public:
  explicit Distances(const ConstImageView& marked);

  [[nodiscard]] std::int64_t squared(Index x, Index y) const { return squared_[place(x, y)]; }

 private:
  [[nodiscard]] std::size_t place(Index x, Index y) const {
    return static_cast<std::size_t>(y * width_ + x);
  }
  void mark_column(const ConstImageView& marked, Index x, std::vector<std::int64_t>& along) const;
  [[nodiscard]] std::int64_t nearest_column(const std::vector<std::int64_t>& along, Index x,
                                            Index y) const;

  Index width_;
  std::vector<std::int64_t> squared_;
};

}  // namespace thinbench
