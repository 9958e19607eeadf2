#include "reference.hpp"
#include "repeat.hpp"

namespace thinbench::reference {
namespace {

/// scikit-image's table, for the descriptors k = sum of n[i] 2^i from 0 to 255: 1 removes a pixel
/// in the first sub-iteration, 2 in the second, 3 in both.
constexpr char kTable[] =
    "0001031100001133000030100000103100000000000000002000101030003031"
    "0300000000000000300000001000000022020000000000002000000030001010"
    "0203020300000003000000000000000100000000000000000000000000000000"
    "0203000200000002200000000000000033030002000000003202000032001000";

}  // namespace

template <>
int thin<BuiltInRule::zhang_suen_skimage>(const Repetition& repetition, ConstImageView source,
                                          ImageView destination) {
  const auto removed = [](const Matrix& image, Index x, Index y, int sub) {
    const Neighbours neighbours = neighbours_at(image, x, y);
    int descriptor = 0;
    for (int i = 0; i < 8; ++i) descriptor += neighbours.n[i] ? 1 << i : 0;
    return ((kTable[descriptor] - '0') >> sub & 1) != 0;
  };
  return repeat(2, repetition, source, destination, removed);
}

}  // namespace thinbench::reference
