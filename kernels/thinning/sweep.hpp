// The neighbourhood sweep: one engine for every word type (packed or byte lanes, scalar or SIMD).
//
// It walks down columns of words and keeps three rows in registers, so a word is loaded once a
// sweep (plus its two neighbours for the bits that cross): 3 loads, 1 store, 2 shifts with carry
// and the rule's gates a word. A light pixel must stay light: the padding then needs no care.
#pragma once

#include "core/word.hpp"
#include "thinning/rules.hpp"

namespace thinbench {

template <class Word>
struct RowOfThree {
  Word west, centre, east;
};

template <class Word>
[[gnu::always_inline]] inline RowOfThree<Word> load_row(
    const typename WordTraits<Word>::Element* from) {
  using Traits = WordTraits<Word>;
  const Word centre = Traits::load(from);
  return {Traits::west(centre, from), centre, Traits::east(centre, from)};
}

template <class Word>
[[gnu::always_inline]] inline Neighbourhood<Word> neighbourhood(const RowOfThree<Word>& above,
                                                                const RowOfThree<Word>& here,
                                                                const RowOfThree<Word>& below) {
  return {here.centre, here.east,  above.east,   above.centre, above.west,
          here.west,   below.west, below.centre, below.east};
}

/// Applies sub-iteration `sub` of `Rule` to rows [first, last) of `source` and writes them to
/// `target`; true where any pixel changed. The views are of one size and must not overlap; they
/// come by value because a store could otherwise be taken to change their fields.
template <class Rule, int sub, class Word>
[[gnu::always_inline]] inline bool sweep_rows(
    ConstPlaneView<typename WordTraits<Word>::Element> source,
    PlaneView<typename WordTraits<Word>::Element> target, Index first, Index last) {
  using Traits = WordTraits<Word>;
  Word changed = Traits::zero();
  for (Index x = 0; x < source.row_elements; x += Traits::kElements) {
    auto above = load_row<Word>(source.row(first - 1) + x);
    auto here = load_row<Word>(source.row(first) + x);
    for (Index y = first; y < last; ++y) {
      const auto below = load_row<Word>(source.row(y + 1) + x);
      const Word next = Rule::template next<sub>(neighbourhood(above, here, below));
      Traits::store(target.row(y) + x, next);
      changed =
          ternary(changed, here.centre, next, [](auto a, auto b, auto c) { return a | (b ^ c); });
      above = here;
      here = below;
    }
  }
  return Traits::any(changed);
}

}  // namespace thinbench
