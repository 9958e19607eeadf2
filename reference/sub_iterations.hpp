// How parallel thinning runs: sub-iterations, each into a second matrix, until a whole cycle of
// them changes nothing.
#pragma once

#include <utility>

#include "matrix.hpp"
#include "thinning/border.hpp"

namespace thinbench::reference {

/// The neighbours of a pixel, n[0] east, then anticlockwise; dark is true.
struct Neighbours {
  bool n[8];
};

inline Neighbours neighbours_at(const Matrix& image, Index x, Index y) {
  return {{image.dark(x + 1, y), image.dark(x + 1, y - 1), image.dark(x, y - 1),
           image.dark(x - 1, y - 1), image.dark(x - 1, y), image.dark(x - 1, y + 1),
           image.dark(x, y + 1), image.dark(x + 1, y + 1)}};
}

/// `removed(image, x, y, sub)` says whether a dark pixel goes in sub-iteration `sub`. Returns the
/// number of cycles, the last, which changed nothing, included.
template <class Removed>
int repeat_sub_iterations(int count, Border border, ConstImageView source, ImageView destination,
                          const Removed& removed) {
  Matrix image = matrix_of(source);
  Matrix second(source.width, source.height);
  const auto may_change = [&](Index x, Index y) {
    const bool on_frame = x == 0 || y == 0 || x == source.width - 1 || y == source.height - 1;
    return border == Border::background || !on_frame;
  };
  int cycles = 0;
  for (bool changed = true; changed; ++cycles) {
    changed = false;
    for (int sub = 0; sub < count; ++sub) {
      for (Index y = 0; y < source.height; ++y) {
        for (Index x = 0; x < source.width; ++x) {
          const bool dark = image.dark(x, y);
          const bool goes = dark && may_change(x, y) && removed(image, x, y, sub);
          second.set(x, y, dark && !goes);
          changed = changed || goes;
        }
      }
      std::swap(image, second);
    }
  }
  write_matrix(image, destination);
  return cycles;
}

}  // namespace thinbench::reference
