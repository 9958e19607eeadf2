#include "decisions.hpp"
#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

/// The image before the iteration, and the foreground not yet flagged.
struct Matrices {
  Matrix before;
  Matrix now;
};

/// Whether a foreground pixel is an edge point of the side with a TRUE expression.
bool flags(const Matrices& image, Index x, Index y, Side side) {
  const Neighbours before = neighbours_at(image.before, x, y);
  const Neighbours now = neighbours_at(image.now, x, y);
  return !before.n[neighbour_on(side)] && expression(side, now.n, before.n);
}

/// Returns whether a pixel was flagged.
bool scan(Matrices& image, const Repetition& repetition, const ConstImageView& size, Side one,
          Side other) {
  bool flagged = false;
  for (Index y = 0; y < size.height; ++y) {
    for (Index x = 0; x < size.width; ++x) {
      if (!image.now.at(x, y) || is_fixed(repetition.border, size, x, y)) continue;
      if (!flags(image, x, y, one) && !flags(image, x, y, other)) continue;
      image.now.set(x, y, false);
      flagged = true;
    }
  }
  return flagged;
}

}  // namespace

int spta(const Repetition& repetition, ConstImageView source, ImageView destination) {
  Matrices image = {matrix_of(source), matrix_of(source)};
  int iterations = 0;
  for (bool flagged = true; flagged && iterations < repetition.max_iterations; ++iterations) {
    image.before = image.now;
    flagged = scan(image, repetition, source, Side::left, Side::right);
    flagged = scan(image, repetition, source, Side::top, Side::bottom) || flagged;
  }
  write_matrix(image.now, destination);
  return iterations;
}

}  // namespace thinbench::reference
