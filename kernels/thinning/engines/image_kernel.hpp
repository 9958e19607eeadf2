// Kernels that make the whole image by themselves, on planes of bytes or of packed words.
#pragma once

#include "image/plane_view.hpp"
#include "midpoints/directions.hpp"

namespace thinbench::detail {

/// `run` reads `source`, writes all of `target` and returns the number of passes; `directions`
/// counts for scans only. `scratch` holds `scratch_words(width, height)` words on a cache line and
/// may hold anything. The planes have one size and do not overlap.
template <class T>
struct ImageKernel {
  int (*run)(Directions directions, const ConstPlaneView<T>& source, const PlaneView<T>& target,
             std::uint64_t* scratch);
  Index (*scratch_words)(Index width, Index height);
};

}  // namespace thinbench::detail
