// The original SPTA, with sequential scans: a pixel's decision depends on those before it, so byte
// lanes and threads are impossible. Packed words resolve the dependence within a row by carries.
//
// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
#pragma once

#include "image/plane_view.hpp"
#include "thinbench/options.hpp"

namespace thinbench::detail {

[[nodiscard]] Index spta_scratch_words(Index width, Index height);

/// Thins `source` into `target` until nothing changes or the limit is reached; returns the number
/// of iterations, the last included. `scratch` has spta_scratch_words words; its contents do not
/// matter. The planes have one size and do not overlap.
int thin_spta(Border border, int max_iterations, const ConstBitPlaneView& source,
              const BitPlaneView& target, std::uint64_t* scratch);

}  // namespace thinbench::detail
