// The midpoint scan on 64-bit words (column_scan.hpp). Compiled without auto-vectorisation, to
// measure what packing alone gains.
#include "midpoints/engine.hpp"
#include "techniques/midpoints.hpp"

namespace thinbench::detail {

constinit const ScanKernels kBitpackedScan = ScanEngine<std::uint64_t, Isa::baseline>::kKernels;

}  // namespace thinbench::detail
