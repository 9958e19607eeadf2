// Zhang and Suen's rule as in scikit-image's skeletonize.
#pragma once

#include "rules/built_in/circuits.hpp"

namespace thinbench::detail {

/// The rule of scikit-image's `skeletonize` for 2-D images, which cites Zhang and Suen but decides
/// otherwise in 31 of 512 cases (256 neighbourhoods, two sub-iterations): it removes the corner
/// pixels of staircases, so that lines become 8-connected, and keeps some ends of lines two pixels
/// wide. Given there as a table, which the circuits equal. The second sub-iteration is not the
/// first rotated by 180 degrees: three decisions differ.
///
/// Invariants: idempotent, subset. NOT invariant: topology, as for Zhang and Suen's rule.
struct ZhangSuenSkimage {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    return by_circuit<BuiltInRule::zhang_suen_skimage, sub>(n);
  }
};

template <>
struct RuleType<BuiltInRule::zhang_suen_skimage> {
  using Type = ZhangSuenSkimage;
};

}  // namespace thinbench::detail
