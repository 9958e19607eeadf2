// The neighbourhood sweep: one engine for every word type (packed or byte lanes, scalar or SIMD).
//
// It walks down columns of words and keeps three rows in registers, so a word is loaded once a
// sweep (plus its two neighbours for the bits that cross): 3 loads, 1 store, 2 shifts with carry
// and the rule's gates a word. A light pixel must stay light: the padding then needs no care.
#pragma once

#include "core/word.hpp"
#include "thinning/passes.hpp"

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

/// Applies sub-iteration `sub` of `rule` to the tiles of `band`, see Pass. The views come by value
/// because a store could otherwise be taken to change their fields.
template <class Rule, int sub, class Word>
[[gnu::always_inline]] inline std::uint64_t sweep_band(
    const Rule& rule, ConstPlaneView<typename WordTraits<Word>::Element> source,
    PlaneView<typename WordTraits<Word>::Element> target, Band band) {
  using Traits = WordTraits<Word>;
  std::uint64_t changed_columns = 0;
  for (Index x = 0; x < source.row_elements; x += Traits::kElements) {
    const std::uint64_t columns = band.columns & band.columns_of(x, x + Traits::kElements);
    if (columns == 0) continue;
    Word changed = Traits::zero();
    auto above = load_row<Word>(source.row(band.first - 1) + x);
    auto here = load_row<Word>(source.row(band.first) + x);
    for (Index y = band.first; y < band.last; ++y) {
      const auto below = load_row<Word>(source.row(y + 1) + x);
      const Word next = rule.template next<sub>(neighbourhood(above, here, below));
      Traits::store(target.row(y) + x, next);
      changed =
          ternary(changed, here.centre, next, [](auto a, auto b, auto c) { return a | (b ^ c); });
      above = here;
      here = below;
    }
    if (Traits::any(changed)) changed_columns |= columns;
  }
  return changed_columns;
}

}  // namespace thinbench
