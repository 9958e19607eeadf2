// The neighbourhood sweep on xsimd batches, compiled once for every instruction-set level.
//
// simd_bitpacked: 64 pixels a lane. Cost a batch: 3 loads, 1 store, 6 operations for neighbours (2
// with funnel shifts), the rule's gates, 1 gate to notice change. It should beat simd_bytes by
// about 8, the pixels an operation.
//
// simd_bytes: one pixel a byte lane, neighbours by unaligned loads: 3 loads, 1 store, the gates.
#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/mux_rule.hpp"
#include "thinning/engines/passes.hpp"
#include "thinning/engines/sweep.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <class Batch>
struct SimdSweep {
  using Element = typename Batch::value_type;
  template <class Rule, int sub>
  static std::uint64_t pass(const RuntimeRule*, const Element* fixed,
                            const ConstPlaneView<Element>& source, const PlaneView<Element>& target,
                            const Band& band) {
    return sweep_band<Rule, sub, Batch>(Rule{}, fixed, source, target, band);
  }
};

std::uint64_t runtime_pass(const RuntimeRule* rule, const std::uint64_t* fixed,
                           const ConstBitPlaneView& source, const BitPlaneView& target,
                           const Band& band) {
  return sweep_band<MuxRule, 0, WordBatch>(MuxRule{rule->program}, fixed, source, target, band);
}

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const SimdPasses Exported<SimdPasses, kThisIsa>::kKernels = {
    passes_by_rule<SimdSweep<ByteBatch>>(), passes_by_rule<SimdSweep<WordBatch>>(), &runtime_pass};

}  // namespace thinbench::detail
