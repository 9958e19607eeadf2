// The modified Naccache-Shinghal rule.
#pragma once

#include "rules/built_in/circuits.hpp"

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

  /// By two inputs: removed = (n6 X | n2 Y) ~(n0 n2 n4 n6) with X = n4 ~n1 | n0 ~n3 and
  /// Y = n4 ~n7 | n0 ~n5. By three: gate 4 is n2 Y | n0 n2 n4 n6, and each of the next two adds one
  /// half of n6 X and excludes n0 n2 n4 n6. See docs/experiments.md#word-scan.
  template <int sub, class Word>
  [[gnu::always_inline]] static constexpr Word next(const Neighbourhood<Word>& n) {
    return by_circuit<BuiltInRule::naccache_shinghal, 0>(n);
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
