// Exact Euclidean distances on the pixel grid.
#pragma once

#include <cstdint>
#include <vector>

#include "support/byte_image.hpp"
#include "thinbench/distance.hpp"

namespace thinbench {

/// Squared distances to the nearest marked (not 0) pixel; kNoBackground where none is marked.
class Distances {
 public:
  explicit Distances(const ConstImageView& marked)
      : width_(marked.width), squared_(static_cast<std::size_t>(marked.width * marked.height)) {
    const ByteImage others = image_by(marked.width, marked.height, [&](Index x, Index y) {
      return marked.row(y)[x] == 0 ? 1 : 0;
    });
    squared_distances(others.view(), {squared_.data(), width_, marked.height});
  }

  [[nodiscard]] std::int64_t squared(Index x, Index y) const {
    return squared_[static_cast<std::size_t>(y * width_ + x)];
  }

 private:
  Index width_;
  std::vector<std::int32_t> squared_;
};

}  // namespace thinbench
