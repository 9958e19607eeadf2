// 64 pixels a word in general registers: the neighbourhood sweep without SIMD. Compiled without
// auto-vectorisation, so that the row shows what packing alone gives.
// Cost a word of 64 pixels: 9 loads, 1 store, 12 shifts and ORs for neighbours, the rule in
// two-input operations (14 for Naccache-Shinghal) and its inversions.
#include "thinning/passes.hpp"
#include "thinning/sweep.hpp"

namespace thinbench {
namespace {

struct Bitpacked {
  using Element = std::uint64_t;
  template <class Rule, int sub>
  static bool pass(const RuleModel*, const ConstBitPlaneView& source, const BitPlaneView& target,
                   Index first, Index last) {
    return sweep_rows<Rule, sub, std::uint64_t>(source, target, first, last);
  }
};

}  // namespace

constinit const PassTable<std::uint64_t> ScalarPasses::kBitpacked = make_pass_table<Bitpacked>();

}  // namespace thinbench
