// The Euler number on 64-bit words, for any processor.
//
// Cost per 64 pixels: 4 loads, 4 operations for west neighbours, 6 gates and 2 population counts
// (about 12 operations each without popcnt).
#include "regions/euler.hpp"

namespace thinbench::detail {
namespace {

template <class Connectivity>
std::int64_t count(const ConstBitPlaneView& image, Index first, Index last) {
  return sum_euler<Connectivity, std::uint64_t, WordCounter>(image, first, last);
}

}  // namespace

constinit const EulerKernels kBitpackedEuler = {&count<EulerEight>, &count<EulerFour>};

}  // namespace thinbench::detail
