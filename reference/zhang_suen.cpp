#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {

template <>
int thin<BuiltInRule::zhang_suen>(const Repetition& repetition, ConstImageView source,
                                  ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int sub) {
    const bool p2 = image.at(x, y - 1);
    const bool p3 = image.at(x + 1, y - 1);
    const bool p4 = image.at(x + 1, y);
    const bool p5 = image.at(x + 1, y + 1);
    const bool p6 = image.at(x, y + 1);
    const bool p7 = image.at(x - 1, y + 1);
    const bool p8 = image.at(x - 1, y);
    const bool p9 = image.at(x - 1, y - 1);
    const int a = (!p2 && p3) + (!p3 && p4) + (!p4 && p5) + (!p5 && p6) + (!p6 && p7) +
                  (!p7 && p8) + (!p8 && p9) + (!p9 && p2);
    const int b = p2 + p3 + p4 + p5 + p6 + p7 + p8 + p9;
    const bool c = sub == 0 ? !(p2 && p4 && p6) : !(p2 && p4 && p8);
    const bool d = sub == 0 ? !(p4 && p6 && p8) : !(p2 && p6 && p8);
    return 2 <= b && b <= 6 && a == 1 && c && d;
  };
  return repeat(2, repetition, source, destination, removed);
}

}  // namespace thinbench::reference
