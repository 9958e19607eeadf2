#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

bool interior(const Matrix& image, Index x, Index y) {
  return image.at(x, y) && image.at(x + 1, y) && image.at(x, y - 1) && image.at(x - 1, y) &&
         image.at(x, y + 1);
}

bool is_removed(const Matrix& image, Index x, Index y) {
  const auto pixel = [&](Index dx, Index dy) { return image.at(x + dx, y + dy); };
  const auto inner = [&](Index dx, Index dy) { return interior(image, x + dx, y + dy); };
  const bool a1 = (inner(1, 0) && !pixel(-1, 0)) || (inner(0, -1) && !pixel(0, 1)) ||
                  (inner(-1, 0) && !pixel(1, 0)) || (inner(0, 1) && !pixel(0, -1));
  bool a2 = false;
  bool b = false;
  for (const Index dx : {-1, 1}) {
    for (const Index dy : {-1, 1}) {
      a2 = a2 || (inner(dx, dy) && !pixel(-dx, 0) && !pixel(0, -dy));
      b = b || (pixel(dx, dy) && !pixel(dx, 0) && !pixel(0, dy));
    }
  }
  return (a1 || a2) && !b;
}

}  // namespace

template <>
int thin<BuiltInRule::mb2>(const Repetition& repetition, ConstImageView source,
                           ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int) {
    return is_removed(image, x, y);
  };
  return repeat(1, repetition, source, destination, removed);
}

}  // namespace thinbench::reference
