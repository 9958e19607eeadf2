// The word scan on words of 64 pixels in general registers. Compiled without auto-vectorisation, to
// measure the gain of packing alone.
//
// Cost per word, see word_scan.hpp: 3 loads, 1 store, 6 shifts and ORs for neighbours, the rule in
// two-input operations (14 for Naccache-Shinghal) and its inversions.
#include "thinning/engines/passes.hpp"
#include "thinning/engines/word_scan.hpp"

namespace thinbench::detail {
namespace {

struct Bitpacked {
  using Element = std::uint64_t;
  template <class Rule, int sub>
  static std::uint64_t pass(const RuntimeRule*, const std::uint64_t* fixed,
                            const ConstBitPlaneView& source, const BitPlaneView& target,
                            const Band& band) {
    return scan_band<Rule, sub, std::uint64_t>(Rule{}, fixed, source, target, band);
  }
};

}  // namespace

constinit const PassesByRule<std::uint64_t> ScalarPasses::kBitpacked = passes_by_rule<Bitpacked>();

}  // namespace thinbench::detail
