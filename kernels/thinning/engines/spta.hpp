// The original SPTA. Its scans are sequential: a pixel depends on the pixels before it, so there
// are no byte lanes and no threads. In packed words, carries resolve the dependence within a row.
//
// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

[[nodiscard]] Index spta_scratch_words(Index width, Index height);

/// Thins `source` into `target` until nothing changes or `max_iterations` is reached; returns the
/// number of iterations, including the last. `scratch` has spta_scratch_words() words and may be
/// uninitialised. The planes have equal sizes and do not overlap.
int thin_spta(Border border, int max_iterations, const ConstBitPlaneView& source,
              const BitPlaneView& target, std::uint64_t* scratch);

}  // namespace thinbench::detail
