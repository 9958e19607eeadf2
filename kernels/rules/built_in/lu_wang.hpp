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

  /// If Zhang and Suen remove a pixel, its foreground neighbours are consecutive. Hence it has
  /// three or more if and only if two of them are two places apart: two adjacent sides or two
  /// adjacent corners. Adds six three-input or nine two-input gates.
  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    const Word two_sides = (n.n0 | n.n4) & (n.n2 | n.n6);
    const Word two_corners = (n.n1 | n.n5) & (n.n3 | n.n7);
    const Word kept = ZhangSuen::next<sub>(n);
    return kept | (n.p & ~(two_sides | two_corners));
  }
};

template <>
struct RuleType<BuiltInRule::lu_wang> {
  using Type = LuWang;
};

}  // namespace thinbench::detail
