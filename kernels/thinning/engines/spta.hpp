// The original SPTA, whose scans run in order: a pixel's decision depends on those before it, so
// there are no lanes of bytes and no threads; packed words resolve the dependence along a row by
// carries.
//
// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

/// Words of `scratch` for images of this size.
[[nodiscard]] Index spta_scratch_words(Index width, Index height);

/// Thins `source` into `target` until nothing changes or `max_iterations` are done; returns the
/// number of iterations, the last included. `scratch` may hold anything. The planes have one size
/// and do not overlap.
int thin_spta(Border border, int max_iterations, const ConstBitPlaneView& source,
              const BitPlaneView& target, std::uint64_t* scratch);

}  // namespace thinbench::detail
