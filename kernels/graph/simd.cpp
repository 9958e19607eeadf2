// Node and line pixels on vectors of words. Compiled per ISA.
#include "core/exported.hpp"
#include "graph/node_pixels.hpp"
#include "simd/vector.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

void split(const ConstBitPlaneView& image, const BitPlaneView& nodes, const BitPlaneView& lines,
           Index first, Index last) {
  split_pixels<WordBatch>(image, nodes, lines, first, last);
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const GraphKernels Exported<GraphKernels, kThisIsa>::kKernels = {&split};

}  // namespace thinbench::detail
