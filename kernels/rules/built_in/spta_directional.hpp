// SPTA, the safe-point thinning algorithm, with parallel sub-iterations.
#pragma once

#include "rules/built_in/circuits.hpp"

namespace thinbench::detail {

/// Naccache and Shinghal's SPTA (IEEE SMC 14(3), 1984), one side per sub-iteration: left, right,
/// top, bottom. A foreground pixel is removed if its neighbour on that side is background and the
/// expression of that side (B4, B0, B2 or B6) is TRUE.
///
/// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
struct SptaDirectional {
  static constexpr int kSubIterations = 4;
  static constexpr int kRotations[kSubIterations] = {0, 4, 6, 2};

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& unrotated) {
    return by_circuit<BuiltInRule::spta_directional, 0>(rotated<kRotations[sub]>(unrotated));
  }

  /// As published, on lanes that hold 0 or 1.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& unrotated) {
    const Neighbourhood<Lane> n = rotated<kRotations[sub]>(unrotated);
    const Neighbourhood<Lane> c = complement(n);
    return static_cast<Lane>(n.p & ((c.n4 & edge_expression(n, c)) ^ 1));
  }
};

template <>
struct RuleType<BuiltInRule::spta_directional> {
  using Type = SptaDirectional;
};

}  // namespace thinbench::detail
