// The scanning skeleton on words of 64 pixels in general registers, see sweep.hpp. Compiled without
// auto-vectorisation, so that the row shows what packing alone gives.
#include "midpoints/engine.hpp"

namespace thinbench::detail {

constinit const ScanKernels kBitpackedScan =
    ScanEngine<std::uint64_t, Isa::baseline>::kKernels;

}  // namespace thinbench::detail
