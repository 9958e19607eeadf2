// The matrices of the paper.
#pragma once

#include <vector>

#include "thinbench/image_view.hpp"

namespace thinbench::reference {

/// Foreground (1) and background (0) pixels, one byte each, with a margin one pixel wide, which is
/// background unless `outside` is true. Every pixel begins as the margin.
class Matrix {
 public:
  Matrix(Index width, Index height, bool outside = false)
      : stride_(width + 2),
        pixels_(static_cast<std::size_t>(stride_ * (height + 2)), outside ? 1 : 0) {}

  [[nodiscard]] bool at(Index x, Index y) const { return pixels_[index(x, y)] != 0; }
  void set(Index x, Index y, bool foreground) { pixels_[index(x, y)] = foreground ? 1 : 0; }

 private:
  [[nodiscard]] std::size_t index(Index x, Index y) const {
    return static_cast<std::size_t>((y + 1) * stride_ + x + 1);
  }

  Index stride_;
  std::vector<std::uint8_t> pixels_;
};

inline Matrix matrix_of(const ConstImageView& source, bool outside = false) {
  Matrix image(source.width, source.height, outside);
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) image.set(x, y, source.row(y)[x] != 0);
  }
  return image;
}

inline void write_matrix(const Matrix& image, const ImageView& destination) {
  for (Index y = 0; y < destination.height; ++y) {
    for (Index x = 0; x < destination.width; ++x) {
      destination.row(y)[x] = image.at(x, y) ? 255 : 0;
    }
  }
}

}  // namespace thinbench::reference
