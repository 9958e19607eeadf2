#include "decisions.hpp"
#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {

template <>
int thin<BuiltInRule::spta_directional>(const Repetition& repetition, ConstImageView source,
                                        ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int sub) {
    const auto side = static_cast<Side>(sub);
    const Neighbours at = neighbours_at(image, x, y);
    return !at.n[neighbour_on(side)] && expression(side, at.n, at.n);
  };
  return repeat(4, repetition, source, destination, removed);
}

}  // namespace thinbench::reference
