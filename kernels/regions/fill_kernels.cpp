// Filling holes by flooding the background. Compiled for every ISA.
//
// Cost: per visit of 64 pixels 12 instructions to spread towards high bits and 10 to 35 back, or
// per 512 pixels about 40 where a register holds them; images of parts take two to three visits of
// a row, most of which only test whether there is anything to spread: 4 instructions.
#include "regions/fill_kernels.hpp"

#include "core/exported.hpp"
#include "regions/flood.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

/// For so many pixels words take less time than a register of 512.
constexpr Index kMaxWidthOfWords = 256;

template <bool with_corners>
bool flood(const ConstBitPlaneView& image, const BitPlaneView& filled) {
  if constexpr (kRegisterHoldsRow) {
    if (image.width > kMaxWidthOfWords) {
      return Flood<BlockFlood<WordBatch>, with_corners>(image, filled)();
    }
  }
  return Flood<WordFlood, with_corners>(image, filled)();
}

}  // namespace

}  // namespace THINBENCH_ISA

template <>
constinit const FloodKernels Exported<FloodKernels, kThisIsa>::kKernels = {
    &THINBENCH_ISA::flood<false>, &THINBENCH_ISA::flood<true>};

}  // namespace thinbench::detail
