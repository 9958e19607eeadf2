#include "reference.hpp"
#include "sub_iterations.hpp"

namespace thinbench::reference {
namespace {

bool interior(const Matrix& image, Index x, Index y) {
  return image.dark(x, y) && image.dark(x + 1, y) && image.dark(x, y - 1) && image.dark(x - 1, y) &&
         image.dark(x, y + 1);
}

bool goes(const Matrix& image, Index x, Index y) {
  const auto dark = [&](Index dx, Index dy) { return image.dark(x + dx, y + dy); };
  const auto inner = [&](Index dx, Index dy) { return interior(image, x + dx, y + dy); };
  const bool a1 = (inner(1, 0) && !dark(-1, 0)) || (inner(0, -1) && !dark(0, 1)) ||
                  (inner(-1, 0) && !dark(1, 0)) || (inner(0, 1) && !dark(0, -1));
  bool a2 = false;
  bool b = false;
  for (const Index dx : {-1, 1}) {
    for (const Index dy : {-1, 1}) {
      a2 = a2 || (inner(dx, dy) && !dark(-dx, 0) && !dark(0, -dy));
      b = b || (dark(dx, dy) && !dark(dx, 0) && !dark(0, dy));
    }
  }
  return (a1 || a2) && !b;
}

}  // namespace

int thin_mb2(Border border, ConstImageView source, ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int) { return goes(image, x, y); };
  return repeat_sub_iterations(1, border, source, destination, removed);
}

}  // namespace thinbench::reference
