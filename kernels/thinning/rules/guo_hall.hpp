// The second rule of OpenCV, which keeps topology.
#pragma once

#include "thinning/rules/neighbourhood.hpp"

namespace thinbench::detail {

/// Guo and Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989: removed
/// where C = 1, N is 2 or 3 and the sub-iteration's edge condition holds (second sub-iteration:
/// rotated by 180 degrees).
///
/// Invariants: topology, idempotent, subset.
struct GuoHall {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& as_seen) {
    return by_native_gates<GuoHall>(rotated<4 * sub>(as_seen));
  }

  /// Ten gates, update included.
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

  /// Nineteen gates, no inverter, update included.
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

  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& as_seen) {
    const Neighbourhood<Lane> n = rotated<4 * sub>(as_seen);
    const auto negated = [](Lane a) { return static_cast<Lane>(a ^ 1); };
    const Lane crossings =
        static_cast<Lane>((negated(n.n2) & (n.n1 | n.n0)) + (negated(n.n0) & (n.n7 | n.n6)) +
                          (negated(n.n6) & (n.n5 | n.n4)) + (negated(n.n4) & (n.n3 | n.n2)));
    const Lane pairs_1 =
        static_cast<Lane>((n.n3 | n.n2) + (n.n1 | n.n0) + (n.n7 | n.n6) + (n.n5 | n.n4));
    const Lane pairs_2 =
        static_cast<Lane>((n.n2 | n.n1) + (n.n0 | n.n7) + (n.n6 | n.n5) + (n.n4 | n.n3));
    const Lane fewer = pairs_1 < pairs_2 ? pairs_1 : pairs_2;
    const Lane edge = static_cast<Lane>((n.n6 | n.n5 | negated(n.n3)) & n.n4);
    const bool removed = (crossings == 1) & (fewer >= 2) & (fewer <= 3) & (edge == 0);
    return static_cast<Lane>(n.p & (removed ? 0 : 1));
  }
};

template <>
struct RuleType<Rule::guo_hall> {
  using Type = GuoHall;
};

}  // namespace thinbench::detail
