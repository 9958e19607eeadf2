// The midpoint scan on bytes, and on words in general registers. Plain data, safe to include in
// files of every ISA.
#pragma once

#include "midpoints/state.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {

/// On words of 64 pixels, compiled once, for the baseline.
extern const ScanKernels kBitpackedScan;

/// On planes of bytes, in loops that compilers vectorise. `scratch` has
/// `scratch_words(width, height)` words, aligned to a cache line; its contents do not matter.
struct ByteScanKernels {
  void (*run)(Directions directions, const ConstBytePlaneView& source, const BytePlaneView& target,
              std::uint64_t* scratch);
  Index (*scratch_words)(Index width, Index height);
};

/// The techniques that the scan is compared with.
[[nodiscard]] VariantList<MidpointState> midpoint_techniques();

}  // namespace thinbench::detail
