// The original SPTA: what decides over one pixel, and the kernels that run its scans in order. A
// pixel's decision depends on those before it in the scan, so there are no lanes of bytes and no
// threads; packed words resolve the dependence along a row by carries.
//
// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
#pragma once

#include "thinning/engines/image_kernel.hpp"

namespace thinbench::detail {

/// The two scans of a pass.
enum class SptaScan : int { left_right, top_bottom };

/// Whether a dark pixel that is not flagged yet is flagged: bit i of `before` says that neighbour i
/// was dark before the pass, bit i of `now` that it is dark and not flagged.
constexpr bool spta_flags(SptaScan scan, unsigned before, unsigned now) {
  const auto b = [before](int i) { return (before >> (i % 8) & 1) != 0; };
  const auto n = [now](int i) { return (now >> (i % 8) & 1) != 0; };
  // B4 with neighbour i + turn for neighbour i: B2, B0 and B6 are B4 turned.
  const auto edge = [&](int turn) {
    return !b(4 + turn) && n(turn) && (n(1 + turn) || n(2 + turn) || n(6 + turn) || n(7 + turn)) &&
           (n(2 + turn) || !b(3 + turn)) && (!b(5 + turn) || n(6 + turn));
  };
  return scan == SptaScan::left_right ? edge(0) || edge(4) : edge(6) || edge(2);
}

struct SptaKernels {
  static const ImageKernel<std::uint8_t> kLut;
  static const ImageKernel<std::uint64_t> kBitpacked;
};

}  // namespace thinbench::detail
