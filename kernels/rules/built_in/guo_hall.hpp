// Guo and Hall's rule, as in OpenCV. Preserves topology.
#pragma once

#include "rules/built_in/circuits.hpp"

namespace thinbench::detail {

/// Guo and Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989, algorithm
/// A1. A foreground pixel is removed if
///   C = 1         C = !n2 (n1 + n0) + !n0 (n7 + n6) + !n6 (n5 + n4) + !n4 (n3 + n2)
///   2 <= N <= 3   N = min(N1, N2), the foreground pairs in each of the two pairings of the ring
///   (n6 + n5 + !n3) n4 = 0   (second sub-iteration: rotated by 180 degrees)
///
/// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
struct GuoHall {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& unrotated) {
    return by_circuit<BuiltInRule::guo_hall, 0>(rotated<4 * sub>(unrotated));
  }

  /// As published, on lanes that hold 0 or 1.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& unrotated) {
    const Neighbourhood<Lane> n = rotated<4 * sub>(unrotated);
    const auto negated = [](Lane a) { return static_cast<Lane>(a ^ 1); };
    const Lane crossings =
        static_cast<Lane>((negated(n.n2) & (n.n1 | n.n0)) + (negated(n.n0) & (n.n7 | n.n6)) +
                          (negated(n.n6) & (n.n5 | n.n4)) + (negated(n.n4) & (n.n3 | n.n2)));
    const Lane pairs_1 =
        static_cast<Lane>((n.n3 | n.n2) + (n.n1 | n.n0) + (n.n7 | n.n6) + (n.n5 | n.n4));
    const Lane pairs_2 =
        static_cast<Lane>((n.n2 | n.n1) + (n.n0 | n.n7) + (n.n6 | n.n5) + (n.n4 | n.n3));
    const Lane pairs = pairs_1 < pairs_2 ? pairs_1 : pairs_2;
    const Lane edge = static_cast<Lane>((n.n6 | n.n5 | negated(n.n3)) & n.n4);
    const bool removed = (crossings == 1) & (pairs >= 2) & (pairs <= 3) & (edge == 0);
    return static_cast<Lane>(n.p & (removed ? 0 : 1));
  }
};

template <>
struct RuleType<BuiltInRule::guo_hall> {
  using Type = GuoHall;
};

}  // namespace thinbench::detail
