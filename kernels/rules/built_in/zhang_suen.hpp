// Zhang and Suen's rule: "thinning" in most libraries.
#pragma once

#include "rules/built_in/circuits.hpp"

namespace thinbench::detail {

/// Zhang and Suen, "A fast parallel algorithm for thinning digital patterns", CACM 27(3), 1984. A
/// foreground pixel is removed if
///   2 <= B <= 6   B is the number of foreground neighbours
///   A = 1         A is the number of transitions from background to foreground around the pixel
///   n0 n2 n6 = 0 and n0 n4 n6 = 0   (second sub-iteration: rotated by 180 degrees)
///
/// Invariants: idempotent, subset. NOT invariant: topology; squares of 2 x 2 pixels vanish, and
/// with them components; 327,477 of the 2^25 images of 5 x 5 pixels change topology.
struct ZhangSuen {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& unrotated) {
    return by_circuit<BuiltInRule::zhang_suen, 0>(rotated<4 * sub>(unrotated));
  }

  /// As published, on lanes that hold 0 or 1; `min_neighbours` is the least B.
  template <int sub, int min_neighbours = 2, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& unrotated) {
    const Neighbourhood<Lane> n = rotated<4 * sub>(unrotated);
    const auto rises = [](Lane from, Lane to) { return static_cast<Lane>((from ^ 1) & to); };
    const Lane transitions = static_cast<Lane>(
        rises(n.n2, n.n1) + rises(n.n1, n.n0) + rises(n.n0, n.n7) + rises(n.n7, n.n6) +
        rises(n.n6, n.n5) + rises(n.n5, n.n4) + rises(n.n4, n.n3) + rises(n.n3, n.n2));
    const Lane neighbours =
        static_cast<Lane>(n.n0 + n.n1 + n.n2 + n.n3 + n.n4 + n.n5 + n.n6 + n.n7);
    const Lane inner = static_cast<Lane>((n.n2 & n.n0 & n.n6) | (n.n0 & n.n6 & n.n4));
    const bool removed =
        (transitions == 1) & (neighbours >= min_neighbours) & (neighbours <= 6) & (inner == 0);
    return static_cast<Lane>(n.p & (removed ? 0 : 1));
  }
};

template <>
struct RuleType<BuiltInRule::zhang_suen> {
  using Type = ZhangSuen;
};

}  // namespace thinbench::detail
