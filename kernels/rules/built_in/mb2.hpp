// A fully parallel rule with a support of 5 x 5 pixels.
#pragma once

#include "rules/built_in/neighbourhood.hpp"

namespace thinbench::detail {

/// Bernard and Manzanera's MB2, "Improved low complexity fully parallel thinning algorithm", ICIAP
/// 1999. The feature is I, the interior: foreground pixels with four foreground 4-neighbours. A
/// foreground pixel is removed if (a1 or a2) and not b:
///   a1  a 4-neighbour is interior and the opposite one is background
///   a2  a diagonal neighbour is interior and the two opposite 4-neighbours are background
///   b   a diagonal neighbour is foreground and the two 4-neighbours beside it are background
///
/// Invariants: topology (8-connected objects, 4-connected background), idempotent, subset,
/// symmetric under rotation by 90 degrees. NOT invariant: thinness; strokes of even width become
/// two pixels wide.
struct Mb2 {
  static constexpr int kSubIterations = 1;
  static constexpr bool kTwoStages = true;

  /// Two gates.
  template <class Word>
  [[gnu::always_inline]] static constexpr Word feature(const Cross<Word>& at) {
    constexpr auto all = [](auto a, auto b, auto c) { return a & b & c; };
    return ternary(ternary(at.p, at.n0, at.n2, all), at.n4, at.n6, all);
  }

  /// Fifteen gates, including the update of p.
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
    return ternary(edge, alone, n.p, [](auto a, auto b, auto c) { return (~a | b) & c; });
  }

  /// As published, on lanes that hold 0 or 1.
  template <int sub, class Lane>
  [[gnu::always_inline]] static constexpr Lane published(const Neighbourhood<Lane>& n,
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

template <>
struct RuleType<BuiltInRule::mb2> {
  using Type = Mb2;
};

}  // namespace thinbench::detail
