// The reference's arithmetic on bytes 0/1 in a form that compilers vectorise: whole rows, no
// branch, no early exit. Compiled once for every instruction-set level at -O3, so that hand-written
// SIMD is compared with what the compiler gives for free.
#include "core/isa.hpp"
#include "thinning/passes.hpp"

namespace thinbench {
namespace {

struct Autovec {
  using Element = std::uint8_t;
  template <class Rule, int sub>
  static std::uint64_t pass(const RuleModel*, const ConstBytePlaneView& source,
                            const BytePlaneView& target, const Band& band) {
    return for_each_run(band, [&](Index y, Index from, Index to) {
      return row<Rule, sub>(source.row(y - 1) + from, source.row(y) + from,
                            source.row(y + 1) + from, target.row(y) + from, to - from) != 0;
    });
  }

 private:
  template <class Rule, int sub>
  static std::uint8_t row(const std::uint8_t* __restrict above, const std::uint8_t* __restrict here,
                          const std::uint8_t* __restrict below, std::uint8_t* __restrict target,
                          Index count) {
    std::uint8_t changed = 0;
    for (Index x = 0; x < count; ++x) {
      const Neighbourhood<std::uint8_t> n = {here[x],      here[x + 1],  above[x + 1],
                                             above[x],     above[x - 1], here[x - 1],
                                             below[x - 1], below[x],     below[x + 1]};
      const std::uint8_t next = Rule::template printed<sub>(n);
      target[x] = next;
      changed = static_cast<std::uint8_t>(changed | (next ^ n.p));
    }
    return changed;
  }
};

}  // namespace

template <>
constinit const PassTable<std::uint8_t> IsaPasses<Isa::THINBENCH_ISA>::kAutovec =
    make_pass_table<Autovec>();

}  // namespace thinbench
