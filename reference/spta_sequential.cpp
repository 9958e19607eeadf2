#include "matrix.hpp"
#include "reference.hpp"

namespace thinbench::reference {
namespace {

/// The image before the pass, and the pixels that are dark and not flagged yet.
struct Matrices {
  Matrix before;
  Matrix now;
};

/// Whether a dark pixel that is not flagged is an edge point of a side whose expression is TRUE.
bool flags(const Matrices& image, Index x, Index y, bool left_right) {
  const auto at = [x, y](const Matrix& matrix, int i) {
    constexpr Index dx[] = {1, 1, 0, -1, -1, -1, 0, 1};
    constexpr Index dy[] = {0, -1, -1, -1, 0, 1, 1, 1};
    return matrix.dark(x + dx[i], y + dy[i]);
  };
  const auto n = [&](int i) { return at(image.now, i); };
  const auto light = [&](int i) { return !at(image.before, i); };
  if (left_right) {
    const bool b4 =
        n(0) && (n(1) || n(2) || n(6) || n(7)) && (n(2) || light(3)) && (light(5) || n(6));
    const bool b0 =
        n(4) && (n(2) || n(3) || n(5) || n(6)) && (n(6) || light(7)) && (light(1) || n(2));
    return (light(4) && b4) || (light(0) && b0);
  }
  const bool b2 =
      n(6) && (n(0) || n(4) || n(5) || n(7)) && (n(0) || light(1)) && (light(3) || n(4));
  const bool b6 =
      n(2) && (n(0) || n(1) || n(3) || n(4)) && (n(4) || light(5)) && (light(7) || n(0));
  return (light(2) && b2) || (light(6) && b6);
}

/// True where a pixel was flagged.
bool scan(Matrices& image, Index width, Index height, bool left_right) {
  bool flagged = false;
  for (Index y = 0; y < height; ++y) {
    for (Index x = 0; x < width; ++x) {
      if (!image.now.dark(x, y) || !flags(image, x, y, left_right)) continue;
      image.now.set(x, y, false);
      flagged = true;
    }
  }
  return flagged;
}

}  // namespace

int thin_spta(ConstImageView source, ImageView destination) {
  Matrices image = {matrix_of(source), matrix_of(source)};
  int passes = 0;
  for (bool flagged = true; flagged; ++passes) {
    image.before = image.now;
    flagged = scan(image, source.width, source.height, true);
    flagged = scan(image, source.width, source.height, false) || flagged;
  }
  write_matrix(image.now, destination);
  return passes;
}

}  // namespace thinbench::reference
