// Parallel thinning: sub-iterations, each into a second matrix, until an iteration changes nothing.
#pragma once

#include <utility>

#include "matrix.hpp"
#include "reference.hpp"

namespace thinbench::reference {

/// The neighbours of a pixel, n[0] east, then anticlockwise; foreground is true.
struct Neighbours {
  bool n[8];
};

inline Neighbours neighbours_at(const Matrix& image, Index x, Index y) {
  return {{image.at(x + 1, y), image.at(x + 1, y - 1), image.at(x, y - 1), image.at(x - 1, y - 1),
           image.at(x - 1, y), image.at(x - 1, y + 1), image.at(x, y + 1), image.at(x + 1, y + 1)}};
}

/// Whether this pixel must not change.
inline bool is_fixed(Border border, const ConstImageView& image, Index x, Index y) {
  const bool outermost = x == 0 || y == 0 || x == image.width - 1 || y == image.height - 1;
  return border == Border::keep && outermost;
}

/// `removed(image, x, y, sub)`: whether sub-iteration `sub` removes a foreground pixel. Returns the
/// number of iterations, including the last, which changed nothing.
template <class Removed>
int repeat(int sub_iterations, const Repetition& repetition, ConstImageView source,
           ImageView destination, const Removed& removed) {
  Matrix image = matrix_of(source);
  Matrix second(source.width, source.height);
  int iterations = 0;
  for (bool changed = true; changed && iterations < repetition.max_iterations; ++iterations) {
    changed = false;
    for (int sub = 0; sub < sub_iterations; ++sub) {
      for (Index y = 0; y < source.height; ++y) {
        for (Index x = 0; x < source.width; ++x) {
          const bool before = image.at(x, y);
          const bool after =
              before && (is_fixed(repetition.border, source, x, y) || !removed(image, x, y, sub));
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
