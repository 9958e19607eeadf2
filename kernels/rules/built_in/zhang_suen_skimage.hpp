// Zhang and Suen's rule as in scikit-image's skeletonize.
#pragma once

#include "rules/built_in/neighbourhood.hpp"

namespace thinbench::detail {

/// The rule of scikit-image's `skeletonize` for 2-D images, which cites Zhang and Suen but decides
/// otherwise in 31 of 512 cases (256 neighbourhoods, two sub-iterations): it removes the corner
/// pixels of staircases, so that lines become 8-connected, and keeps some ends of lines two pixels
/// wide. Given there as a table; the two circuits below equal it. The second sub-iteration is not
/// the first rotated by 180 degrees: three decisions differ.
///
/// Invariants: idempotent, subset. NOT invariant: topology, as for Zhang and Suen's rule.
struct ZhangSuenSkimage {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    if constexpr (sub == 0) return by_native_gates<First>(n);
    if constexpr (sub == 1) return by_native_gates<Second>(n);
  }

 private:
  struct First {
    /// 19 gates, including the update of p.
    template <class Word>
    [[gnu::always_inline]] static constexpr Word by_three_input_gates(
        const Neighbourhood<Word>& n) {
      const Word g1 =
          ternary(n.n1, n.n2, n.n7, [](auto a, auto b, auto c) { return ~a & (b & c); });
      const Word g2 =
          ternary(n.n0, n.n1, n.n3, [](auto a, auto b, auto c) { return ~a & ~(b | c); });
      const Word g3 = ternary(n.n5, g2, n.n7, [](auto a, auto b, auto c) { return ~c & (a | b); });
      const Word g4 = ternary(g1, g3, n.n4, [](auto a, auto b, auto c) { return ~c & (a | b); });
      const Word g5 = n.n5 & ~n.n3;
      const Word g6 = ternary(n.n6, n.n1, g5, [](auto a, auto b, auto c) { return ~c & ~(a & b); });
      const Word g7 = ~(g6 | n.n7);
      const Word g8 =
          ternary(n.n0, n.n5, n.n1, [](auto a, auto b, auto c) { return a ^ (~c & (a ^ b)); });
      const Word g9 = ternary(n.n6, g8, n.n1, [](auto a, auto b, auto c) { return ~b & (~a | c); });
      const Word g10 =
          ternary(n.n1, n.n4, n.n3, [](auto a, auto b, auto c) { return c & (~b | a); });
      const Word g11 = ternary(g7, g9, g10, [](auto a, auto b, auto c) { return ~a & ~(b | c); });
      const Word g12 = ternary(n.n6, n.n5, g8, [](auto a, auto b, auto c) { return c & (~b | a); });
      const Word g13 =
          ternary(n.n3, n.n1, n.n4, [](auto a, auto b, auto c) { return ~(a & b) & c; });
      const Word g14 =
          ternary(n.n0, n.n5, n.n3, [](auto a, auto b, auto c) { return ~a & (b & c); });
      const Word g15 =
          ternary(g14, n.n2, n.n6, [](auto a, auto b, auto c) { return ~a & (b & c); });
      const Word g16 = ternary(g13, n.n0, g15, [](auto a, auto b, auto c) { return c | (a & b); });
      const Word g17 =
          ternary(n.n7, g12, g16, [](auto a, auto b, auto c) { return ~c & (~a | b); });
      const Word g18 = ternary(n.n2, g11, g17, [](auto a, auto b, auto c) { return c & (a | b); });
      return static_cast<Word>(
          ternary(g4, g18, n.p, [](auto a, auto b, auto c) { return c & (~b | a); }));
    }

    /// 32 gates, including the update of p; no inverters.
    template <class Word>
    [[gnu::always_inline]] static constexpr Word by_two_input_gates(const Neighbourhood<Word>& n) {
      const Word g1 = static_cast<Word>(n.n3 | n.n1);
      const Word g2 = static_cast<Word>(n.n0 | g1);
      const Word g3 = static_cast<Word>(g2 & ~n.n5);
      const Word g4 = static_cast<Word>(n.n4 | n.n7);
      const Word g5 = static_cast<Word>(g3 | g4);
      const Word g6 = static_cast<Word>(n.n5 | n.n1);
      const Word g7 = static_cast<Word>(n.n1 & ~n.n0);
      const Word g8 = static_cast<Word>(g6 & ~g7);
      const Word g9 = static_cast<Word>(g1 & g8);
      const Word g10 = static_cast<Word>(g9 | n.n6);
      const Word g11 = static_cast<Word>(n.n3 & n.n1);
      const Word g12 = static_cast<Word>(g10 & ~g11);
      const Word g13 = static_cast<Word>(g12 | n.n2);
      const Word g14 = static_cast<Word>(n.n2 & ~n.n5);
      const Word g15 = static_cast<Word>(n.n3 & n.n4);
      const Word g16 = static_cast<Word>(g15 & ~n.n0);
      const Word g17 = static_cast<Word>(g16 & ~g14);
      const Word g18 = static_cast<Word>(g6 & ~n.n7);
      const Word g19 = static_cast<Word>(n.n3 | n.n2);
      const Word g20 = static_cast<Word>(g18 | g19);
      const Word g21 = static_cast<Word>(g20 & n.n6);
      const Word g22 = static_cast<Word>(g21 & ~g17);
      const Word g23 = static_cast<Word>(n.n5 & ~n.n6);
      const Word g24 = static_cast<Word>(g8 & ~g23);
      const Word g25 = static_cast<Word>(n.n7 & ~g24);
      const Word g26 = static_cast<Word>(n.n4 & n.n0);
      const Word g27 = static_cast<Word>(g26 & ~g11);
      const Word g28 = static_cast<Word>(g25 | g27);
      const Word g29 = static_cast<Word>(g22 | g28);
      const Word g30 = static_cast<Word>(g13 & ~g29);
      const Word g31 = static_cast<Word>(g5 & g30);
      return static_cast<Word>(n.p & ~g31);
    }
  };

  struct Second {
    /// 18 gates, including the update of p.
    template <class Word>
    [[gnu::always_inline]] static constexpr Word by_three_input_gates(
        const Neighbourhood<Word>& n) {
      const Word g1 =
          ternary(n.n7, n.n5, n.n0, [](auto a, auto b, auto c) { return ~(a & b) & c; });
      const Word g2 =
          ternary(n.n5, n.n2, n.n7, [](auto a, auto b, auto c) { return ~c & (a | b); });
      const Word g3 = ternary(n.n6, n.n2, g2, [](auto a, auto b, auto c) { return ~c & (~a | b); });
      const Word g4 = ternary(g1, g3, n.n4, [](auto a, auto b, auto c) { return c & (a | b); });
      const Word g5 = ~(n.n2 | n.n7);
      const Word g6 =
          ternary(n.n4, n.n0, n.n3, [](auto a, auto b, auto c) { return ~c & (a | b); });
      const Word g7 =
          ternary(g5, g6, n.n1, [](auto a, auto b, auto c) { return a ^ (~c & ~(a ^ b)); });
      const Word g8 = g7 & ~n.n5;
      const Word g9 =
          ternary(n.n1, n.n5, n.n3, [](auto a, auto b, auto c) { return ~c & (a | b); });
      const Word g10 =
          ternary(n.n1, n.n7, n.n2, [](auto a, auto b, auto c) { return ~(a & b) & c; });
      const Word g11 = ternary(n.n6, g9, g10, [](auto a, auto b, auto c) { return c & (a | b); });
      const Word g12 =
          ternary(n.n3, n.n0, n.n1, [](auto a, auto b, auto c) { return c & (~b | a); });
      const Word g13 =
          ternary(n.n7, n.n0, n.n2, [](auto a, auto b, auto c) { return c & (~a | b); });
      const Word g14 =
          ternary(n.n3, n.n6, n.n4, [](auto a, auto b, auto c) { return ~c & ~(~a & b); });
      const Word g15 = ternary(n.n5, g5, g14, [](auto a, auto b, auto c) { return c & (a | b); });
      const Word g16 = ternary(g12, g13, g15, [](auto a, auto b, auto c) { return ~c & (~a | b); });
      const Word g17 = ternary(g8, g11, g16, [](auto a, auto b, auto c) { return ~a & (~b & c); });
      return static_cast<Word>(
          ternary(g4, g17, n.p, [](auto a, auto b, auto c) { return c & (~b | a); }));
    }

    /// 34 gates, including the update of p; no inverters.
    template <class Word>
    [[gnu::always_inline]] static constexpr Word by_two_input_gates(const Neighbourhood<Word>& n) {
      const Word g1 = static_cast<Word>(n.n1 | n.n5);
      const Word g2 = static_cast<Word>(g1 & ~n.n3);
      const Word g3 = static_cast<Word>(g2 | n.n6);
      const Word g4 = static_cast<Word>(n.n1 & n.n7);
      const Word g5 = static_cast<Word>(g3 & ~g4);
      const Word g6 = static_cast<Word>(n.n4 & n.n0);
      const Word g7 = static_cast<Word>(g5 | g6);
      const Word g8 = static_cast<Word>(g7 & n.n2);
      const Word g9 = static_cast<Word>(n.n1 & ~n.n0);
      const Word g10 = static_cast<Word>(n.n4 & ~n.n6);
      const Word g11 = static_cast<Word>(g9 | g10);
      const Word g12 = static_cast<Word>(g11 & n.n7);
      const Word g13 = static_cast<Word>(n.n5 & n.n7);
      const Word g14 = static_cast<Word>(g6 & ~g13);
      const Word g15 = static_cast<Word>(g9 & ~n.n2);
      const Word g16 = static_cast<Word>(n.n6 & ~n.n3);
      const Word g17 = static_cast<Word>(n.n5 & ~n.n4);
      const Word g18 = static_cast<Word>(g17 & ~g16);
      const Word g19 = static_cast<Word>(g15 | g18);
      const Word g20 = static_cast<Word>(g14 | g19);
      const Word g21 = static_cast<Word>(n.n4 | n.n0);
      const Word g22 = static_cast<Word>(g21 & ~n.n3);
      const Word g23 = static_cast<Word>(g22 | g1);
      const Word g24 = static_cast<Word>(n.n5 | n.n7);
      const Word g25 = static_cast<Word>(n.n3 & n.n1);
      const Word g26 = static_cast<Word>(g24 & ~g25);
      const Word g27 = static_cast<Word>(n.n6 & ~n.n1);
      const Word g28 = static_cast<Word>(g27 | n.n2);
      const Word g29 = static_cast<Word>(g26 | g28);
      const Word g30 = static_cast<Word>(g23 & g29);
      const Word g31 = static_cast<Word>(g30 & ~g20);
      const Word g32 = static_cast<Word>(g31 & ~g12);
      const Word g33 = static_cast<Word>(g32 & ~g8);
      return static_cast<Word>(n.p & ~g33);
    }
  };
};

template <>
struct RuleType<BuiltInRule::zhang_suen_skimage> {
  using Type = ZhangSuenSkimage;
};

}  // namespace thinbench::detail
