#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {

template <>
int thin<BuiltInRule::lu_wang>(const Repetition& repetition, ConstImageView source,
                               ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int sub) {
    const auto& n = neighbours_at(image, x, y).n;  // anticlockwise from the east
    int neighbours = 0;
    int crossings = 0;
    for (int i = 0; i < 8; ++i) {
      neighbours += n[i] ? 1 : 0;
      crossings += !n[i] && n[(i + 1) % 8] ? 1 : 0;
    }
    const bool edge = sub == 0 ? !(n[2] && n[0] && n[6]) && !(n[0] && n[6] && n[4])
                               : !(n[2] && n[0] && n[4]) && !(n[2] && n[6] && n[4]);
    return 3 <= neighbours && neighbours <= 6 && crossings == 1 && edge;
  };
  return repeat(2, repetition, source, destination, removed);
}

}  // namespace thinbench::reference
