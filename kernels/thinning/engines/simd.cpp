// The word scan on xsimd batches, compiled once for every ISA.
//
// simd_bitpacked: 64 pixels per lane. Cost per batch: 3 loads, 1 store, 6 operations for neighbours
// (2 with funnel shifts), the rule's gates, 1 gate to detect changes. Each operation computes 8
// times as many pixels as in simd_bytes.
//
// simd_bytes: one pixel per byte lane. Cost per batch: 3 loads (2 of them unaligned, for
// neighbours), 1 store, the rule's gates.
#include "dispatch/exported.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/passes.hpp"
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {
namespace {

template <class Batch>
struct SimdWordScan {
  using Element = typename Batch::value_type;
  template <class Rule, int sub>
  static std::uint64_t pass(const RuntimeRule*, const Element* fixed,
                            const ConstPlaneView<Element>& source, const PlaneView<Element>& target,
                            const Band& band) {
    return scan_band<Rule, sub, Batch>(Rule{}, fixed, source, target, band);
  }
};

}  // namespace
}  // namespace THINBENCH_ISA

template <>
constinit const SimdPasses Exported<SimdPasses, kThisIsa>::kKernels = {
    passes_by_rule<SimdWordScan<ByteBatch>>(), passes_by_rule<SimdWordScan<WordBatch>>()};

}  // namespace thinbench::detail
