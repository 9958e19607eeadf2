// Zhang and Suen's rule, modified to preserve slanted lines.
#pragma once

#include "rules/built_in/zhang_suen.hpp"

namespace thinbench::detail {

/// Lu and Wang, "A comment on 'A fast parallel algorithm for thinning digital patterns'", CACM
/// 29(3), 1986: Zhang and Suen's rule with 3 to 6 foreground neighbours instead of 2 to 6, so that
/// slanted lines two pixels wide keep their length.
///
/// Invariants: idempotent, subset. NOT invariant: topology, as for Zhang and Suen's rule.
struct LuWang {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& unrotated) {
    return by_circuit<BuiltInRule::lu_wang, 0>(rotated<4 * sub>(unrotated));
  }

  /// As published, on lanes that hold 0 or 1.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& n) {
    return ZhangSuen::published<sub, 3>(n);
  }
};

template <>
struct RuleType<BuiltInRule::lu_wang> {
  using Type = LuWang;
};

}  // namespace thinbench::detail
