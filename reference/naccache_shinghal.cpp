#include "decisions.hpp"
#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {

template <>
int thin<BuiltInRule::naccache_shinghal>(const Repetition& repetition, ConstImageView source,
                                         ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int) {
    return !keeps_with(false_count<int>(expressions_of(neighbours_at(image, x, y).n)));
  };
  return repeat(1, repetition, source, destination, removed);
}

}  // namespace thinbench::reference
