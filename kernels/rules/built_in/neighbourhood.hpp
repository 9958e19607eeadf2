// The input of rules: a pixel and its neighbours, as words of any type.
//
// Neighbours are numbered as in the paper (Fig. 6), anticlockwise from the east:
//     n3 n2 n1
//     n4  p n0
//     n5 n6 n7
// Foreground is 1, background 0. The descriptor of a neighbourhood is k = sum of n_i 2^i.
#pragma once

#include "simd/word.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// The type that implements a parallel rule; specialised in the rule's own file.
template <BuiltInRule rule>
struct RuleType;

template <class Word>
struct Neighbourhood {
  Word p, n0, n1, n2, n3, n4, n5, n6, n7;
};

/// The neighbourhood rotated by `eighths` times 45 degrees: n_i of the result is n_(i + eighths).
template <int eighths, class Word>
[[gnu::always_inline]] constexpr Neighbourhood<Word> rotated(const Neighbourhood<Word>& n) {
  static_assert(eighths % 2 == 0 && 0 <= eighths && eighths < 8);
  if constexpr (eighths == 2) return {n.p, n.n2, n.n3, n.n4, n.n5, n.n6, n.n7, n.n0, n.n1};
  if constexpr (eighths == 4) return {n.p, n.n4, n.n5, n.n6, n.n7, n.n0, n.n1, n.n2, n.n3};
  if constexpr (eighths == 6) return {n.p, n.n6, n.n7, n.n0, n.n1, n.n2, n.n3, n.n4, n.n5};
  return n;
}

/// B4 of section 3.1, for left edge points: n0 (n1 + n2 + n6 + n7) (n2 + !n3) (!n5 + n6). The
/// others are B4 of a rotated neighbourhood: B0 by 4 eighths, B2 by 6, B6 by 2. `c` has the
/// complements of the neighbours.
template <class Word>
[[gnu::always_inline]] constexpr Word edge_expression(const Neighbourhood<Word>& n,
                                                      const Neighbourhood<Word>& c) {
  return static_cast<Word>(n.n0 & (n.n1 | n.n2 | n.n6 | n.n7) & (n.n2 | c.n3) & (c.n5 | n.n6));
}

/// Inverts all pixels, on lanes that hold 0 or 1.
template <class Lane>
[[gnu::always_inline]] constexpr Neighbourhood<Lane> complement(const Neighbourhood<Lane>& n) {
  const auto flip = [](Lane a) { return static_cast<Lane>(a ^ 1); };
  return {flip(n.p),  flip(n.n0), flip(n.n1), flip(n.n2), flip(n.n3),
          flip(n.n4), flip(n.n5), flip(n.n6), flip(n.n7)};
}

/// A pixel and its four 4-neighbours.
template <class Word>
struct Cross {
  Word p, n0, n2, n4, n6;
};

/// A rule with a support of 5 x 5 pixels, computed in two stages: the feature of every pixel from
/// its Cross, then the new pixel from the neighbourhoods of pixels and of features.
///
/// Must be monotonic: removing pixels must not create features, and losing features must not cause
/// the removal of a pixel that would be kept. Hence a pixel that was kept stays as long as nothing
/// changes within one pixel of it, even if pixels two away change.
template <class Rule>
concept TwoStageRule = Rule::kTwoStages;

}  // namespace thinbench::detail
