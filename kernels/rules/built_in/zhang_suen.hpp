// Zhang and Suen's rule: "thinning" in most libraries.
#pragma once

#include "rules/built_in/neighbourhood.hpp"

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
    return by_native_gates<ZhangSuen>(rotated<4 * sub>(unrotated));
  }

  /// Eleven gates, including the update of p.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_three_input_gates(const Neighbourhood<Word>& n) {
    constexpr auto same_or_other = [](auto a, auto b, auto c) { return ~((a ^ b) & ~(a ^ c)); };
    const Word g1 = ternary(n.n1, n.n2, n.n3, same_or_other);
    const Word g2 =
        ternary(n.n0, n.n5, n.n6, [](auto a, auto b, auto c) { return (a & c) | (~b & (a | c)); });
    const Word g3 =
        ternary(n.n1, n.n4, n.n5, [](auto a, auto b, auto c) { return ~((a ^ b) & (a ^ c)); });
    const Word g4 =
        ternary(g1, n.n5, n.n7, [](auto a, auto b, auto c) { return ~(a ^ (b & ~(a & c))); });
    const Word g5 = ternary(g4, n.n2, n.n4, [](auto a, auto b, auto c) { return ~c & (a | ~b); });
    const Word g6 =
        ternary(g5, g2, n.n7, [](auto a, auto b, auto c) { return (a & c) | (~b & (a | c)); });
    const Word g7 = ternary(g6, n.n1, n.n6, same_or_other);
    const Word g8 = ternary(g3, g6, n.n3, [](auto a, auto b, auto c) { return a & ~(b ^ c); });
    const Word g9 =
        ternary(g2, g6, n.n0, [](auto a, auto b, auto c) { return ~((a ^ b) | (a ^ c)); });
    const Word kept = ternary(g1, g7, g9, [](auto a, auto b, auto c) { return ~a | (b & ~c); });
    return ternary(kept, g8, n.p, [](auto a, auto b, auto c) { return c & (a | b); });
  }

  /// Twenty-nine gates, including the update of p; no inverters.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_two_input_gates(const Neighbourhood<Word>& n) {
    const Word g1 = n.n2 & ~n.n7;
    const Word g2 = g1 | n.n0;
    const Word g3 = g2 & ~n.n5;
    const Word g4 = n.n5 | n.n3;
    const Word g5 = n.n4 & ~n.n7;
    const Word g6 = g4 & g5;
    const Word g7 = g6 | n.n6;
    const Word g8 = g3 | g7;
    const Word g9 = n.n1 & ~n.n6;
    const Word g10 = n.n0 & ~g9;
    const Word g11 = n.n6 & ~n.n5;
    const Word g12 = g10 | g11;
    const Word g13 = g12 & ~n.n7;
    const Word g14 = n.n6 & ~n.n4;
    const Word g15 = n.n0 & ~n.n2;
    const Word g16 = g11 | g15;
    const Word g17 = g14 | g16;
    const Word g18 = n.n3 | n.n4;
    const Word g19 = g17 & g18;
    const Word g20 = g13 | g19;
    const Word g21 = g8 & ~g20;
    const Word g22 = n.n3 & ~g10;
    const Word g23 = g9 & ~n.n4;
    const Word g24 = n.n2 & ~g23;
    const Word g25 = g24 & ~g22;
    const Word g26 = n.n1 & ~g2;
    const Word g27 = g25 | g26;
    const Word g28 = g21 & ~g27;
    return n.p & ~g28;
  }

  /// As published, on lanes that hold 0 or 1.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& unrotated) {
    const Neighbourhood<Lane> n = rotated<4 * sub>(unrotated);
    const auto rises = [](Lane from, Lane to) { return static_cast<Lane>((from ^ 1) & to); };
    const Lane transitions = static_cast<Lane>(
        rises(n.n2, n.n1) + rises(n.n1, n.n0) + rises(n.n0, n.n7) + rises(n.n7, n.n6) +
        rises(n.n6, n.n5) + rises(n.n5, n.n4) + rises(n.n4, n.n3) + rises(n.n3, n.n2));
    const Lane neighbours =
        static_cast<Lane>(n.n0 + n.n1 + n.n2 + n.n3 + n.n4 + n.n5 + n.n6 + n.n7);
    const Lane inner = static_cast<Lane>((n.n2 & n.n0 & n.n6) | (n.n0 & n.n6 & n.n4));
    const bool removed = (transitions == 1) & (neighbours >= 2) & (neighbours <= 6) & (inner == 0);
    return static_cast<Lane>(n.p & (removed ? 0 : 1));
  }
};

template <>
struct RuleType<BuiltInRule::zhang_suen> {
  using Type = ZhangSuen;
};

}  // namespace thinbench::detail
