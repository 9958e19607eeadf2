#include "matrix.hpp"
#include "reference.hpp"

namespace thinbench::reference {
namespace {

/// One step along a direction, in the order in which pixels are visited.
struct Step {
  Index x;
  Index y;
};

constexpr Step step_of(Direction direction) {
  switch (direction) {
    case Direction::rows:
      return {1, 0};
    case Direction::columns:
      return {0, 1};
    case Direction::diagonals:
      return {1, 1};
    default:
      return {-1, 1};
  }
}

/// Marks the centre of the run whose first pixel is (x, y).
void mark_centre(const Matrix& image, Matrix& marks, Index x, Index y, Step step) {
  Index length = 1;
  while (image.dark(x + length * step.x, y + length * step.y)) ++length;
  const Index centre = (length - 1) / 2;
  marks.set(x + centre * step.x, y + centre * step.y, true);
}

}  // namespace

int skeleton_scan(Directions directions, ConstImageView source, ImageView destination) {
  const Matrix image = matrix_of(source);
  Matrix marks(source.width, source.height);
  for (const Direction direction : kAllDirections) {
    if (!directions.has(direction)) continue;
    const Step step = step_of(direction);
    for (Index y = 0; y < source.height; ++y) {
      for (Index x = 0; x < source.width; ++x) {
        const bool first = image.dark(x, y) && !image.dark(x - step.x, y - step.y);
        if (first) mark_centre(image, marks, x, y, step);
      }
    }
  }
  write_matrix(marks, destination);
  return 1;
}

}  // namespace thinbench::reference
