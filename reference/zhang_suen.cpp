#include "reference.hpp"
#include "sub_iterations.hpp"

namespace thinbench::reference {

int thin_zhang_suen(Border border, ConstImageView source, ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int sub) {
    const bool p2 = image.dark(x, y - 1);
    const bool p3 = image.dark(x + 1, y - 1);
    const bool p4 = image.dark(x + 1, y);
    const bool p5 = image.dark(x + 1, y + 1);
    const bool p6 = image.dark(x, y + 1);
    const bool p7 = image.dark(x - 1, y + 1);
    const bool p8 = image.dark(x - 1, y);
    const bool p9 = image.dark(x - 1, y - 1);
    const int a = (!p2 && p3) + (!p3 && p4) + (!p4 && p5) + (!p5 && p6) + (!p6 && p7) +
                  (!p7 && p8) + (!p8 && p9) + (!p9 && p2);
    const int b = p2 + p3 + p4 + p5 + p6 + p7 + p8 + p9;
    const bool c = sub == 0 ? !(p2 && p4 && p6) : !(p2 && p4 && p8);
    const bool d = sub == 0 ? !(p4 && p6 && p8) : !(p2 && p6 && p8);
    return 2 <= b && b <= 6 && a == 1 && c && d;
  };
  return repeat_sub_iterations(2, border, source, destination, removed);
}

}  // namespace thinbench::reference
