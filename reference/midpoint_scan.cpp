#include "matrix.hpp"
#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

/// From one pixel to the next in a direction.
struct Offset {
  Index x;
  Index y;
};

constexpr Offset offset_of(Direction direction) {
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

/// Marks the midpoint of the run whose first pixel is (x, y).
void mark_midpoint(const Matrix& image, Matrix& marks, Index x, Index y, Offset offset) {
  Index length = 1;
  while (image.at(x + length * offset.x, y + length * offset.y)) ++length;
  const Index middle = (length - 1) / 2;
  marks.set(x + middle * offset.x, y + middle * offset.y, true);
}

}  // namespace

int midpoint_scan(Directions directions, Border border, ConstImageView source,
                  ImageView destination) {
  const Matrix image = matrix_of(source);
  Matrix marks(source.width, source.height);
  for (const Direction direction : kAllDirections) {
    if (!directions.has(direction)) continue;
    const Offset offset = offset_of(direction);
    for (Index y = 0; y < source.height; ++y) {
      for (Index x = 0; x < source.width; ++x) {
        const bool first = image.at(x, y) && !image.at(x - offset.x, y - offset.y);
        if (first) mark_midpoint(image, marks, x, y, offset);
      }
    }
  }
  for (Index y = 0; y < source.height; ++y) {
    for (Index x = 0; x < source.width; ++x) {
      if (is_fixed(border, source, x, y)) marks.set(x, y, image.at(x, y));
    }
  }
  write_matrix(marks, destination);
  return 1;
}

}  // namespace thinbench::reference
