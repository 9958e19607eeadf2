#include <algorithm>

#include "reference.hpp"
#include "sub_iterations.hpp"

namespace thinbench::reference {

int thin_guo_hall(Border border, ConstImageView source, ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int sub) {
    const bool p2 = image.dark(x, y - 1);
    const bool p3 = image.dark(x + 1, y - 1);
    const bool p4 = image.dark(x + 1, y);
    const bool p5 = image.dark(x + 1, y + 1);
    const bool p6 = image.dark(x, y + 1);
    const bool p7 = image.dark(x - 1, y + 1);
    const bool p8 = image.dark(x - 1, y);
    const bool p9 = image.dark(x - 1, y - 1);
    const int c =
        (!p2 && (p3 || p4)) + (!p4 && (p5 || p6)) + (!p6 && (p7 || p8)) + (!p8 && (p9 || p2));
    const int n1 = (p9 || p2) + (p3 || p4) + (p5 || p6) + (p7 || p8);
    const int n2 = (p2 || p3) + (p4 || p5) + (p6 || p7) + (p8 || p9);
    const int n = std::min(n1, n2);
    const bool m = sub == 0 ? (p6 || p7 || !p9) && p8 : (p2 || p3 || !p5) && p4;
    return c == 1 && 2 <= n && n <= 3 && !m;
  };
  return repeat_sub_iterations(2, border, source, destination, removed);
}

}  // namespace thinbench::reference
