#include <utility>

#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

/// The 3 x 3 window of a pixel: bit k is its pixel k in raster order, bit 0 the north-west one.
std::size_t window_at(const Matrix& image, Index x, Index y) {
  std::size_t window = 0;
  for (Index row = 0; row < 3; ++row) {
    for (Index column = 0; column < 3; ++column) {
      if (image.at(x - 1 + column, y - 1 + row)) window |= std::size_t{1} << (3 * row + column);
    }
  }
  return window;
}

}  // namespace

int apply_tables(std::span<const WindowTable> sub_iterations, const Repetition& repetition,
                 ConstImageView source, ImageView destination) {
  const bool outside = repetition.border == Border::foreground;
  Matrix image = matrix_of(source, outside);
  Matrix second(source.width, source.height, outside);
  int iterations = 0;
  for (bool changed = true; changed && iterations < repetition.max_iterations; ++iterations) {
    changed = false;
    for (const WindowTable& table : sub_iterations) {
      for (Index y = 0; y < source.height; ++y) {
        for (Index x = 0; x < source.width; ++x) {
          const bool before = image.at(x, y);
          const bool fixed = is_fixed(repetition.border, source, x, y);
          const bool after = fixed ? before : table[window_at(image, x, y)];
          second.set(x, y, after);
          changed = changed || after != before;
        }
      }
      std::swap(image, second);
    }
  }
  write_matrix(image, destination);
  return iterations;
}

}  // namespace thinbench::reference
