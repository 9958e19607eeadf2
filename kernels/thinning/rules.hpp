// Thinning rules: what one pixel becomes, given its 3x3 neighbourhood. Each rule stands here once,
// as an expression over any word type, and every engine instantiates it.
//
// Neighbours are numbered as in the paper (Fig. 6), anticlockwise from the east:
//     n3 n2 n1
//     n4  p n0
//     n5 n6 n7
// Dark is 1. The descriptor of a neighbourhood is k = sum of n_i 2^i.
#pragma once

#include "core/word.hpp"

namespace thinbench {

template <class Word>
struct Neighbourhood {
  Word p, n0, n1, n2, n3, n4, n5, n6, n7;
};

/// The modified Naccache-Shinghal rule of the paper (section 3.1): a dark pixel is removed where
/// one or two of B0, B2, B4, B6 are FALSE, and stays where none, three or four are.
///
/// Invariants: a light pixel stays light; the rule is symmetric under quarter turns and mirrors;
/// each removal on its own keeps topology. NOT invariant: removing all at once, as a pass does,
/// takes bars of two pixels' width away and breaks slanted lines, so skeletons of the printed
/// procedure fall into fragments: 13,908,139 of the 2^25 images of 5 x 5 pixels change topology.
struct NaccacheShinghal {
  static constexpr int kSubIterations = 1;

  /// The new pixel. Two circuits, because the best for gates of three inputs is a poor one for two:
  /// on the test image it is 10 % faster with vpternlog, 5 to 10 % slower on AVX2 and SSE and 40 %
  /// in general registers, where its chain is longer.
  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    if constexpr (TernaryGate<Word>::kOneInstruction) {
      return by_three_input_gates(n);
    } else {
      return by_two_input_gates(n);
    }
  }

  /// removed = (n6 X | n2 Y) ~(n0 n2 n4 n6) with X = n4 ~n1 | n0 ~n3 and Y = n4 ~n7 | n0 ~n5: 14
  /// gates, no inverter, update included.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_two_input_gates(const Neighbourhood<Word>& n) {
    const Word x = (n.n4 & ~n.n1) | (n.n0 & ~n.n3);
    const Word y = (n.n4 & ~n.n7) | (n.n0 & ~n.n5);
    const Word edge = (n.n6 & x) | (n.n2 & y);
    const Word inner = (n.n0 & n.n4) & (n.n2 & n.n6);
    return n.p & ~(edge & ~inner);
  }

  /// Eight gates, update included. `north` is the part of n2 Y that the case n0 n6 leaves, and each
  /// of the two terms after it takes one half of X. Found by simulated annealing over networks;
  /// four gates were proved too few for the decision alone, seven with the update were not found.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_three_input_gates(const Neighbourhood<Word>& n) {
    constexpr auto both = [](auto a, auto b, auto) { return a & b; };
    constexpr auto and_not = [](auto a, auto b, auto) { return a & ~b; };
    constexpr auto unless_alone = [](auto a, auto b, auto c) { return a & ~(b & ~c); };
    constexpr auto and_or = [](auto a, auto b, auto c) { return a & (b | c); };
    constexpr auto flip = [](auto a, auto b, auto c) { return a ^ (b & ~(c & ~a)); };
    const Word south_east = ternary(n.n0, n.n6, n.n6, both);
    const Word south_west = ternary(n.n4, n.n6, n.n6, both);
    const Word west = ternary(n.n4, n.n7, south_east, unless_alone);
    const Word east = ternary(n.n0, n.n5, n.n5, and_not);
    const Word north = ternary(n.n2, west, east, and_or);
    const Word removed_west = ternary(north, south_west, n.n1, flip);
    const Word removed_east = ternary(north, south_east, n.n3, flip);
    return ternary(n.p, removed_west, removed_east,
                   [](auto a, auto b, auto c) { return a & ~(b | c); });
  }

  /// The same, as printed: four expressions and a count of the FALSE ones, on words that hold 0 or
  /// 1 in a whole lane. What a compiler is given to vectorise.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane printed(const Neighbourhood<Lane>& n) {
    const auto negated = [](Lane a) { return static_cast<Lane>(a ^ 1); };
    const Lane b4 = static_cast<Lane>(n.n0 & (n.n1 | n.n2 | n.n6 | n.n7) & (n.n2 | negated(n.n3)) &
                                      (negated(n.n5) | n.n6));
    const Lane b0 = static_cast<Lane>(n.n4 & (n.n2 | n.n3 | n.n5 | n.n6) & (n.n6 | negated(n.n7)) &
                                      (negated(n.n1) | n.n2));
    const Lane b2 = static_cast<Lane>(n.n6 & (n.n0 | n.n4 | n.n5 | n.n7) & (n.n0 | negated(n.n1)) &
                                      (negated(n.n3) | n.n4));
    const Lane b6 = static_cast<Lane>(n.n2 & (n.n0 | n.n1 | n.n3 | n.n4) & (n.n4 | negated(n.n5)) &
                                      (negated(n.n7) | n.n0));
    const Lane true_count = static_cast<Lane>(b0 + b2 + b4 + b6);
    const Lane one_or_two_false = true_count == 3 || true_count == 2 ? 1 : 0;
    return static_cast<Lane>(n.p & negated(one_or_two_false));
  }
};

/// The neighbourhood as seen after turning by `eighths` of a full turn: n_i becomes n_(i +
/// eighths).
template <int eighths, class Word>
[[gnu::always_inline]] constexpr Neighbourhood<Word> turned(const Neighbourhood<Word>& n) {
  static_assert(eighths % 2 == 0 && 0 <= eighths && eighths < 8);
  if constexpr (eighths == 0) {
    return n;
  } else {
    return turned<eighths - 2>(
        Neighbourhood<Word>{n.p, n.n2, n.n3, n.n4, n.n5, n.n6, n.n7, n.n0, n.n1});
  }
}

/// Zhang and Suen, "A fast parallel algorithm for thinning digital patterns", CACM 27(3), 1984: a
/// dark pixel is removed where it has 2 to 6 dark neighbours, one step from light to dark on the
/// way round it, and a light one among n0, n2, n6 and among n0, n4, n6 (second sub-iteration: the
/// same turned by half a turn).
///
/// Invariants: idempotent, the result is a subset. NOT invariant: squares of 2 x 2 pixels vanish,
/// and with them components; 327,477 of the 2^25 images of 5 x 5 pixels change topology.
struct ZhangSuen {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& as_seen) {
    const Neighbourhood<Word> n = turned<4 * sub>(as_seen);
    if constexpr (TernaryGate<Word>::kOneInstruction) {
      return by_three_input_gates(n);
    } else {
      return by_two_input_gates(n);
    }
  }

  /// Eleven gates, update included. Found by simulated annealing over networks.
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
        ternary(g2, g5, n.n7, [](auto a, auto b, auto c) { return (b & c) | (~a & (b | c)); });
    const Word g7 = ternary(g6, n.n1, n.n6, same_or_other);
    const Word g8 = ternary(g3, g6, n.n3, [](auto a, auto b, auto c) { return a & ~(b ^ c); });
    const Word g9 =
        ternary(g2, g6, n.n0, [](auto a, auto b, auto c) { return ~((a ^ b) | (a ^ c)); });
    const Word stays = ternary(g1, g7, g9, [](auto a, auto b, auto c) { return ~a | (b & ~c); });
    return ternary(stays, g8, n.p, [](auto a, auto b, auto c) { return c & (a | b); });
  }

  /// Twenty-nine gates, no inverter, update included: found by logic minimisation over orders of
  /// the inputs.
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

  /// As published, on words that hold 0 or 1 in a whole lane.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane printed(const Neighbourhood<Lane>& as_seen) {
    const Neighbourhood<Lane> n = turned<4 * sub>(as_seen);
    const auto rises = [](Lane from, Lane to) { return static_cast<Lane>((from ^ 1) & to); };
    const Lane steps = static_cast<Lane>(rises(n.n2, n.n1) + rises(n.n1, n.n0) + rises(n.n0, n.n7) +
                                         rises(n.n7, n.n6) + rises(n.n6, n.n5) + rises(n.n5, n.n4) +
                                         rises(n.n4, n.n3) + rises(n.n3, n.n2));
    const Lane dark = static_cast<Lane>(n.n0 + n.n1 + n.n2 + n.n3 + n.n4 + n.n5 + n.n6 + n.n7);
    const Lane inner = static_cast<Lane>((n.n2 & n.n0 & n.n6) | (n.n0 & n.n6 & n.n4));
    const bool removed = (steps == 1) & (dark >= 2) & (dark <= 6) & (inner == 0);
    return static_cast<Lane>(n.p & (removed ? 0 : 1));
  }
};

/// One direction a sub-iteration, each on the result of the one before: left, right, top, bottom
/// edge points of Naccache and Shinghal's SPTA (IEEE SMC 14(3), 1984), that is, dark pixels with a
/// light neighbour on that side whose expression (B4, B0, B2 or B6) is TRUE, are removed.
///
/// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset.
struct SptaDirectional {
  static constexpr int kSubIterations = 4;
  static constexpr int kTurns[kSubIterations] = {0, 4, 6, 2};

  /// Five gates, update included.
  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& as_seen) {
    const Neighbourhood<Word> n = turned<kTurns[sub]>(as_seen);
    const Word u = ternary(n.n2, n.n3, n.n0, [](auto a, auto b, auto c) { return (a | ~b) & c; });
    const Word v = ternary(n.n6, n.n5, n.n4, [](auto a, auto b, auto c) { return (a | ~b) & ~c; });
    const Word w = ternary(n.n1, n.n2, n.n7, [](auto a, auto b, auto c) { return a | b | c; });
    const Word x = ternary(w, n.n6, u, [](auto a, auto b, auto c) { return (a | b) & c; });
    return ternary(n.p, x, v, [](auto a, auto b, auto c) { return a & ~(b & c); });
  }

  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane printed(const Neighbourhood<Lane>& as_seen) {
    const Neighbourhood<Lane> n = turned<kTurns[sub]>(as_seen);
    const auto negated = [](Lane a) { return static_cast<Lane>(a ^ 1); };
    const Lane b4 = static_cast<Lane>(n.n0 & (n.n1 | n.n2 | n.n6 | n.n7) & (n.n2 | negated(n.n3)) &
                                      (negated(n.n5) | n.n6));
    return static_cast<Lane>(n.p & negated(static_cast<Lane>(negated(n.n4) & b4)));
  }
};

/// Guo and Hall, "Parallel thinning with two-subiteration algorithms", CACM 32(3), 1989: removed
/// where C = 1, N is 2 or 3 and the sub-iteration's edge condition holds (second: turned by half a
/// turn).
///
/// Invariants: topology, idempotent, subset.
struct GuoHall {
  static constexpr int kSubIterations = 2;

  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& as_seen) {
    const Neighbourhood<Word> n = turned<4 * sub>(as_seen);
    if constexpr (TernaryGate<Word>::kOneInstruction) {
      return by_three_input_gates(n);
    } else {
      return by_two_input_gates(n);
    }
  }

  /// Ten gates, update included.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_three_input_gates(const Neighbourhood<Word>& n) {
    constexpr auto and_either = [](auto a, auto b, auto c) { return ~a & (b | c); };
    constexpr auto and_implied = [](auto a, auto b, auto c) { return ~a & (b | ~c); };
    const Word corner =
        ternary(n.n3, n.n1, n.n7, [](auto a, auto b, auto c) { return ~a & b & c; });
    const Word g1 = ternary(n.n5, n.n2, corner, and_either);
    const Word g2 = ternary(g1, n.n3, n.n6, and_implied);
    const Word g3 = ternary(n.n4, n.n5, n.n0, and_either);
    const Word g4 = ternary(g3, n.n6, n.n3, and_implied);
    const Word g5 = ternary(n.n5, n.n4, n.n1, and_either);
    const Word g6 = ternary(n.n0, n.n7, g5, and_implied);
    const Word south_east =
        ternary(n.n2, n.n1, n.n7, [](auto a, auto b, auto c) { return ~(a | b) & c; });
    const Word removed = ternary(g4, south_east, g6, and_implied);
    return ternary(n.p, g2, removed, [](auto a, auto b, auto c) { return a & (b | ~c); });
  }

  /// Nineteen gates, no inverter, update included: found by logic minimisation over orders of the
  /// inputs.
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
  [[gnu::always_inline]] static constexpr Lane printed(const Neighbourhood<Lane>& as_seen) {
    const Neighbourhood<Lane> n = turned<4 * sub>(as_seen);
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

/// A pixel and its four direct neighbours.
template <class Word>
struct Cross {
  Word p, n0, n2, n4, n6;
};

/// Rules with a support of 5 x 5 pixels in two stages: a feature of every pixel from its Cross,
/// then the new pixel from the neighbourhoods of pixels and of features.
template <class Rule>
concept TwoStageRule = Rule::kTwoStages;

/// Bernard and Manzanera's MB2, "Improved low complexity fully parallel thinning algorithm", ICIAP
/// 1999. The feature is I, the interior: a dark pixel with four dark direct neighbours. Removed
/// where (a1 or a2) and not b: a1 is I on one side and light opposite, a2 is I on a diagonal and
/// light at the two opposite direct neighbours, b is a dark diagonal between two light direct
/// neighbours.
///
/// Invariants: topology, idempotent, subset. Lines two pixels wide stay where the width is even.
struct Mb2 {
  static constexpr int kSubIterations = 1;
  static constexpr bool kTwoStages = true;

  /// Two gates.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word feature(const Cross<Word>& at) {
    constexpr auto all = [](auto a, auto b, auto c) { return a & b & c; };
    return ternary(ternary(at.p, at.n0, at.n2, all), at.n4, at.n6, all);
  }

  /// Fifteen gates, update included.
  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n,
                                                    const Neighbourhood<Word>& interior) {
    constexpr auto or_without = [](auto a, auto b, auto c) { return a | (b & ~c); };
    constexpr auto without = [](auto a, auto b, auto) { return a & ~b; };
    const Neighbourhood<Word>& i = interior;
    const Word to_west = ternary(ternary(i.n0, i.n1, n.n6, or_without), i.n7, n.n2, or_without);
    const Word to_east = ternary(ternary(i.n4, i.n3, n.n6, or_without), i.n5, n.n2, or_without);
    const Word vertical = ternary(ternary(i.n2, n.n6, n.n6, without), i.n6, n.n2, or_without);
    const Word edge =
        ternary(ternary(vertical, to_west, n.n4, or_without), to_east, n.n0, or_without);
    const Word north = ternary(ternary(n.n1, n.n0, n.n0, without), n.n3, n.n4, or_without);
    const Word south = ternary(ternary(n.n5, n.n4, n.n4, without), n.n7, n.n0, or_without);
    const Word alone = ternary(ternary(north, n.n2, n.n2, without), south, n.n6, or_without);
    return ternary(n.p, edge, alone, [](auto a, auto b, auto c) { return a & (~b | c); });
  }

  /// As published, on words that hold 0 or 1 in a whole lane.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane printed(const Neighbourhood<Lane>& n,
                                                       const Neighbourhood<Lane>& i) {
    const auto off = [](Lane a) { return static_cast<Lane>(a ^ 1); };
    const Lane a1 = static_cast<Lane>((i.n0 & off(n.n4)) | (i.n2 & off(n.n6)) | (i.n4 & off(n.n0)) |
                                      (i.n6 & off(n.n2)));
    const Lane a2 =
        static_cast<Lane>((i.n1 & off(n.n4) & off(n.n6)) | (i.n3 & off(n.n0) & off(n.n6)) |
                          (i.n5 & off(n.n0) & off(n.n2)) | (i.n7 & off(n.n4) & off(n.n2)));
    const Lane b =
        static_cast<Lane>((n.n1 & off(n.n0) & off(n.n2)) | (n.n3 & off(n.n4) & off(n.n2)) |
                          (n.n5 & off(n.n4) & off(n.n6)) | (n.n7 & off(n.n0) & off(n.n6)));
    return static_cast<Lane>(n.p & off(static_cast<Lane>((a1 | a2) & off(b))));
  }
};

template <class... Rules>
struct RuleList {};

/// Every rule that engines instantiate. A new rule is a struct above and a name here.
using AllRules = RuleList<NaccacheShinghal, ZhangSuen, GuoHall, SptaDirectional, Mb2>;

}  // namespace thinbench
