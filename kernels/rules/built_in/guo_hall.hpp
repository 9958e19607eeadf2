// Guo and Hall's rule, as in OpenCV. Preserves topology.
#pragma once

#include "rules/built_in/neighbourhood.hpp"

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
    return by_native_gates<GuoHall>(rotated<4 * sub>(unrotated));
  }

  /// Ten gates, including the update of p.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_three_input_gates(const Neighbourhood<Word>& n) {
    constexpr auto and_either = [](auto a, auto b, auto c) { return ~a & (b | c); };
    constexpr auto and_implied = [](auto a, auto b, auto c) { return ~a & (b | ~c); };
    const Word corner =
        ternary(n.n3, n.n1, n.n7, [](auto a, auto b, auto c) { return ~a & b & c; });
    const Word g1 =
        ternary(corner, n.n2, n.n5, [](auto a, auto b, auto c) { return (a | b) & ~c; });
    const Word g2 = ternary(g1, n.n3, n.n6, and_implied);
    const Word g3 = ternary(n.n4, n.n5, n.n0, and_either);
    const Word g4 = ternary(g3, n.n6, n.n3, and_implied);
    const Word g5 = ternary(n.n5, n.n4, n.n1, and_either);
    const Word g6 = ternary(g5, n.n7, n.n0, [](auto a, auto b, auto c) { return (~a | b) & ~c; });
    const Word south_east =
        ternary(n.n2, n.n1, n.n7, [](auto a, auto b, auto c) { return ~(a | b) & c; });
    const Word removed = ternary(g4, south_east, g6, and_implied);
    return ternary(removed, g2, n.p, [](auto a, auto b, auto c) { return (~a | b) & c; });
  }

  /// Nineteen gates, including the update of p; no inverters.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_two_input_gates(const Neighbourhood<Word>& n) {
    const Word g1 = n.n1 & n.n7;
    const Word g2 = g1 & ~n.n5;
    const Word g3 = g2 | n.n6;
    const Word g4 = g3 & ~n.n3;
    const Word g5 = n.n2 & ~n.n5;
    const Word g6 = g4 | g5;
    const Word g7 = n.n1 | n.n4;
    const Word g8 = g7 & ~n.n7;
    const Word g9 = n.n5 & ~n.n2;
    const Word g10 = g9 & n.n7;
    const Word g11 = g8 | g10;
    const Word g12 = n.n0 | g11;
    const Word g13 = n.n1 & ~n.n0;
    const Word g14 = g13 | n.n4;
    const Word g15 = n.n3 & ~n.n6;
    const Word g16 = g14 & ~g15;
    const Word g17 = g12 & ~g16;
    const Word g18 = g6 & g17;
    return n.p & ~g18;
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
