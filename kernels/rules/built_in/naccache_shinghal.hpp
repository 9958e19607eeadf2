// The modified Naccache-Shinghal rule.
#pragma once

#include "rules/built_in/neighbourhood.hpp"

namespace thinbench::detail {

/// The rule of the paper, section 3.1: a foreground pixel is removed if one or two of B0, B2, B4,
/// B6 are FALSE, and kept if none, three or four are.
///
/// Invariants: subset; symmetric under rotation by 90 degrees and reflection; removing a single
/// pixel preserves topology. NOT invariant: topology. Simultaneous removal, as in an iteration,
/// erases bars two pixels wide and breaks slanted lines, so skeletons are fragmented: 13,908,139 of
/// the 2^25 images of 5 x 5 pixels change topology.
struct NaccacheShinghal {
  static constexpr int kSubIterations = 1;

  /// Two circuits: on ISAs without three-input gates, the three-input circuit has a longer
  /// dependency chain than the two-input one. See docs/experiments.md#one-circuit-for-every-isa.
  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    return by_native_gates<NaccacheShinghal>(n);
  }

  /// removed = (n6 X | n2 Y) ~(n0 n2 n4 n6) with X = n4 ~n1 | n0 ~n3 and Y = n4 ~n7 | n0 ~n5: 14
  /// gates, including the update of p; no inverters.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_two_input_gates(const Neighbourhood<Word>& n) {
    const Word x = (n.n4 & ~n.n1) | (n.n0 & ~n.n3);
    const Word y = (n.n4 & ~n.n7) | (n.n0 & ~n.n5);
    const Word edge = (n.n6 & x) | (n.n2 & y);
    const Word inner = (n.n0 & n.n4) & (n.n2 & n.n6);
    return n.p & ~(edge & ~inner);
  }

  /// Eight gates, including the update of p. `north` is n2 Y | n0 n2 n4 n6; each of
  /// the next two gates adds one half of n6 X and excludes n0 n2 n4 n6. A search found no smaller
  /// circuit: docs/experiments.md#smaller-circuits.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word by_three_input_gates(const Neighbourhood<Word>& n) {
    constexpr auto both = [](auto a, auto b, auto) { return a & b; };
    constexpr auto and_not = [](auto a, auto b, auto) { return a & ~b; };
    constexpr auto unless_alone = [](auto a, auto b, auto c) { return a & ~(b & ~c); };
    constexpr auto and_or = [](auto a, auto b, auto c) { return a & (b | c); };
    constexpr auto flip = [](auto a, auto b, auto c) { return a ^ (b & ~(c & ~a)); };
    constexpr auto flipped_by = [](auto a, auto b, auto c) { return b ^ (a & ~(c & ~b)); };
    const Word south_east = ternary(n.n0, n.n6, n.n6, both);
    const Word south_west = ternary(n.n4, n.n6, n.n6, both);
    const Word west = ternary(n.n4, n.n7, south_east, unless_alone);
    const Word east = ternary(n.n0, n.n5, n.n5, and_not);
    const Word north = ternary(n.n2, west, east, and_or);
    const Word removed_west = ternary(south_west, north, n.n1, flipped_by);
    const Word removed_east = ternary(north, south_east, n.n3, flip);
    return ternary(removed_west, removed_east, n.p,
                   [](auto a, auto b, auto c) { return ~(a | b) & c; });
  }

  /// As published, on lanes that hold 0 or 1: counts the FALSE expressions.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& n) {
    const Neighbourhood<Lane> c = complement(n);
    const Lane b4 = edge_expression(n, c);
    const Lane b0 = edge_expression(rotated<4>(n), rotated<4>(c));
    const Lane b2 = edge_expression(rotated<6>(n), rotated<6>(c));
    const Lane b6 = edge_expression(rotated<2>(n), rotated<2>(c));
    const Lane true_count = static_cast<Lane>(b0 + b2 + b4 + b6);
    const Lane one_or_two_false = true_count == 3 || true_count == 2 ? 1 : 0;
    return static_cast<Lane>(n.p & (one_or_two_false ^ 1));
  }
};

template <>
struct RuleType<BuiltInRule::naccache_shinghal> {
  using Type = NaccacheShinghal;
};

}  // namespace thinbench::detail
