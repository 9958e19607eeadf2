// The midpoint scan on words of 64 pixels in general registers, see column_scan.hpp. Compiled
// without auto-vectorisation, to measure what packing alone gives.
#include "midpoints/engine.hpp"

namespace thinbench::detail {

constinit const ScanKernels kBitpackedScan = ScanEngine<std::uint64_t, Isa::baseline>::kKernels;

}  // namespace thinbench::detail
