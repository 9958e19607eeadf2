// Node and line pixels on 64-bit words: 9 loads, 2 stores and about 50 gates per 64 pixels.
#include "graph/node_pixels.hpp"

namespace thinbench::detail {

constinit const GraphKernels kBitpackedGraph = {&split_pixels<std::uint64_t>};

}  // namespace thinbench::detail
