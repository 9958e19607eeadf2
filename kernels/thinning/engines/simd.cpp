// The neighbourhood sweep on xsimd batches, compiled once for every instruction-set level.
//
// simd_bitpacked: 64 pixels a lane. Cost a batch: 3 loads, 1 store, 6 operations for neighbours (2
// with funnel shifts), the rule's gates, 1 gate to notice change. It should beat simd_bytes by
// about 8, the pixels an operation.
//
// simd_bytes: one pixel a byte lane, neighbours by unaligned loads: 3 loads, 1 store, the gates.
#include "nets/model_passes.hpp"
#include "nets/mux_rule.hpp"
#include "simd/vector.hpp"
#include "thinning/engines/passes.hpp"
#include "thinning/engines/sweep.hpp"

namespace thinbench {
namespace {

template <class Batch>
struct SimdSweep {
  using Element = typename Batch::value_type;
  template <class Rule, int sub>
  static std::uint64_t pass(const RuleModel*, const ConstPlaneView<Element>& source,
                            const PlaneView<Element>& target, const Band& band) {
    return sweep_band<Rule, sub, Batch>(Rule{}, source, target, band);
  }
};

std::uint64_t model_pass(const RuleModel* model, const ConstBitPlaneView& source,
                         const BitPlaneView& target, const Band& band) {
  return sweep_band<MuxRule, 0, WordBatch>(MuxRule{model->program}, source, target, band);
}

}  // namespace

template <>
constinit const PassTable<std::uint8_t> IsaPasses<kThisIsa>::kSimdBytes =
    make_pass_table<SimdSweep<ByteBatch>>();

template <>
constinit const PassTable<std::uint64_t> IsaPasses<kThisIsa>::kSimdBitpacked =
    make_pass_table<SimdSweep<WordBatch>>();

template <>
constinit const Pass<std::uint64_t> IsaModelPasses<kThisIsa>::kSimdBitpacked = &model_pass;

}  // namespace thinbench
