#include <algorithm>

#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

/// The conditions of the article, for its sub-iteration `sub`.
constexpr auto kRemoved = [](const Matrix& image, Index x, Index y, int sub) {
  const bool p2 = image.at(x, y - 1);
  const bool p3 = image.at(x + 1, y - 1);
  const bool p4 = image.at(x + 1, y);
  const bool p5 = image.at(x + 1, y + 1);
  const bool p6 = image.at(x, y + 1);
  const bool p7 = image.at(x - 1, y + 1);
  const bool p8 = image.at(x - 1, y);
  const bool p9 = image.at(x - 1, y - 1);
  const int c =
      (!p2 && (p3 || p4)) + (!p4 && (p5 || p6)) + (!p6 && (p7 || p8)) + (!p8 && (p9 || p2));
  const int n1 = (p9 || p2) + (p3 || p4) + (p5 || p6) + (p7 || p8);
  const int n2 = (p2 || p3) + (p4 || p5) + (p6 || p7) + (p8 || p9);
  const int n = std::min(n1, n2);
  const bool m = sub == 0 ? (p6 || p7 || !p9) && p8 : (p2 || p3 || !p5) && p4;
  return c == 1 && 2 <= n && n <= 3 && !m;
};

}  // namespace

template <>
int thin<BuiltInRule::guo_hall>(const Repetition& repetition, ConstImageView source,
                                ImageView destination) {
  return repeat(2, repetition, source, destination, kRemoved);
}

template <>
int thin<BuiltInRule::guo_hall_skimage>(const Repetition& repetition, ConstImageView source,
                                        ImageView destination) {
  const auto exchanged = [](const Matrix& image, Index x, Index y, int sub) {
    return kRemoved(image, x, y, 1 - sub);
  };
  return repeat(2, repetition, source, destination, exchanged);
}

}  // namespace thinbench::reference
