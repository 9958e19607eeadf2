// The input of rules: a pixel and its neighbours, as words of any kind.
//
// Neighbours are numbered as in the paper (Fig. 6), anticlockwise from the east:
//     n3 n2 n1
//     n4  p n0
//     n5 n6 n7
// Foreground is 1. The descriptor of a neighbourhood is k = sum of n_i 2^i.
#pragma once

#include "simd/word.hpp"
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// The type that implements a parallel rule; specialised in the rule's own file.
template <Rule rule>
struct RuleType;

template <class Word>
struct Neighbourhood {
  Word p, n0, n1, n2, n3, n4, n5, n6, n7;
};

/// The neighbourhood rotated by `eighths` times 45 degrees: n_i becomes n_(i + eighths).
template <int eighths, class Word>
[[gnu::always_inline]] constexpr Neighbourhood<Word> rotated(const Neighbourhood<Word>& n) {
  static_assert(eighths % 2 == 0 && 0 <= eighths && eighths < 8);
  if constexpr (eighths == 2) return {n.p, n.n2, n.n3, n.n4, n.n5, n.n6, n.n7, n.n0, n.n1};
  if constexpr (eighths == 4) return {n.p, n.n4, n.n5, n.n6, n.n7, n.n0, n.n1, n.n2, n.n3};
  if constexpr (eighths == 6) return {n.p, n.n6, n.n7, n.n0, n.n1, n.n2, n.n3, n.n4, n.n5};
  return n;
}

/// B4 of section 3.1, for left edge points: n0 (n1 + n2 + n6 + n7) (n2 + !n3) (!n5 + n6). The other
/// three are B4 of a rotated neighbourhood: B0 by 4 eighths, B2 by 6, B6 by 2. `c` has the
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

/// The circuit of a rule for this word type: of three-input gates where each is one instruction,
/// else of two-input gates.
template <class Rule, class Word>
[[gnu::always_inline]] constexpr Word by_native_gates(const Neighbourhood<Word>& n) {
  if constexpr (TernaryGate<Word>::kOneInstruction) {
    return Rule::by_three_input_gates(n);
  } else {
    return Rule::by_two_input_gates(n);
  }
}

/// A pixel and its four 4-neighbours.
template <class Word>
struct Cross {
  Word p, n0, n2, n4, n6;
};

/// Rules with a support of 5 x 5 pixels in two stages: a feature of every pixel from its Cross,
/// then the new pixel from the neighbourhoods of pixels and of features.
///
/// Two laws: removing pixels never creates a feature, and losing a feature never removes a pixel
/// that was kept. So a pixel is kept as long as nothing changes within one pixel of it, whatever
/// changes two pixels away.
template <class Rule>
concept TwoStageRule = Rule::kTwoStages;

}  // namespace thinbench::detail
