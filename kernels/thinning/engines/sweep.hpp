// The neighbourhood sweep: one engine for every word type (packed or byte lanes, scalar or SIMD).
//
// It walks down columns of words and keeps three rows in registers, so a word is loaded once a
// sweep (plus its two neighbours for the bits that cross): 3 loads, 1 store, 2 shifts with carry
// and the rule's gates a word. A light pixel must stay light: the padding then needs no care.
#pragma once

#include <utility>

#include "simd/word.hpp"
#include "thinning/engines/passes.hpp"

namespace thinbench::detail {

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

template <class Word>
[[gnu::always_inline]] inline Cross<Word> cross(Word above, const RowOfThree<Word>& here,
                                                Word below) {
  return {here.centre, here.east, above, here.west, below};
}

/// Features of a row and beside it. Those beside a word need the pixels two columns to either side,
/// too.
template <class Rule, class Word>
[[gnu::always_inline]] inline RowOfThree<Word> features_beside(const RowOfThree<Word>& above,
                                                               const RowOfThree<Word>& here,
                                                               const RowOfThree<Word>& below,
                                                               Word west2, Word east2) {
  const RowOfThree<Word> to_west = {west2, here.west, here.centre};
  const RowOfThree<Word> to_east = {here.centre, here.east, east2};
  return {Rule::feature(cross(above.west, to_west, below.west)),
          Rule::feature(cross(above.centre, here, below.centre)),
          Rule::feature(cross(above.east, to_east, below.east))};
}

/// What a rule sees while an engine walks down: the rows round row y. `Rows` knows the engine's
/// memory: `row(y)` and, for rules of two stages, `features<Rule>(y, above, here, below)`.
template <class Rule, class Rows>
class Window {
 public:
  using Row = decltype(std::declval<const Rows&>().row(0));

  [[gnu::always_inline]] Window(const Rows& rows, Index first)
      : above_(rows.row(first - 1)), here_(rows.row(first)) {}

  [[nodiscard, gnu::always_inline]] auto centre() const { return here_.centre; }

  /// The new pixels of row y; rows come one after another.
  template <int sub>
  [[gnu::always_inline]] auto next(const Rule& rule, const Rows& rows, Index y) {
    below_ = rows.row(y + 1);
    return rule.template next<sub>(neighbourhood(above_, here_, below_));
  }

  [[gnu::always_inline]] void move_down() {
    above_ = here_;
    here_ = below_;
  }

 private:
  Row above_, here_, below_;
};

/// The same with a second window over features, one row ahead.
template <TwoStageRule Rule, class Rows>
class Window<Rule, Rows> {
 public:
  using Row = decltype(std::declval<const Rows&>().row(0));

  [[gnu::always_inline]] Window(const Rows& rows, Index first)
      : above_(rows.row(first - 1)), here_(rows.row(first)), below_(rows.row(first + 1)) {
    feature_above_ = rows.template features<Rule>(first - 1, rows.row(first - 2), above_, here_);
    feature_here_ = rows.template features<Rule>(first, above_, here_, below_);
  }

  [[nodiscard, gnu::always_inline]] auto centre() const { return here_.centre; }

  template <int sub>
  [[gnu::always_inline]] auto next(const Rule& rule, const Rows& rows, Index y) {
    beyond_ = rows.row(y + 2);
    feature_below_ = rows.template features<Rule>(y + 1, here_, below_, beyond_);
    return rule.template next<sub>(neighbourhood(above_, here_, below_),
                                   neighbourhood(feature_above_, feature_here_, feature_below_));
  }

  [[gnu::always_inline]] void move_down() {
    above_ = here_;
    here_ = below_;
    below_ = beyond_;
    feature_above_ = feature_here_;
    feature_here_ = feature_below_;
  }

 private:
  Row above_, here_, below_, beyond_;
  Row feature_above_, feature_here_, feature_below_;
};

/// Rows of a plane, one word wide.
template <class Word>
struct WordColumn {
  using Traits = WordTraits<Word>;
  const typename Traits::Element* data;
  Index stride;

  [[gnu::always_inline]] RowOfThree<Word> row(Index y) const {
    return load_row<Word>(data + y * stride);
  }

  template <class Rule>
  [[gnu::always_inline]] RowOfThree<Word> features(Index y, const RowOfThree<Word>& above,
                                                   const RowOfThree<Word>& here,
                                                   const RowOfThree<Word>& below) const {
    const auto* from = data + y * stride;
    return features_beside<Rule>(above, here, below, Traits::west2(here.centre, from),
                                 Traits::east2(here.centre, from));
  }
};

/// What of a word's new pixels must stay as it was: the pixels of a mask, or none.
struct NothingFixed {
  template <class Word>
  [[gnu::always_inline]] static Word apply(Word next, Word) {
    return next;
  }
};
template <class Word>
struct FixedPixels {
  Word mask;
  /// Rules only remove pixels, so what must stay is put back.
  [[gnu::always_inline]] Word apply(Word next, Word before) const {
    return ternary(next, before, mask, [](auto a, auto b, auto c) { return a | (b & c); });
  }
};

/// Sub-iteration `sub` of `rule` on one column of words of a band; true where a pixel changed.
template <class Rule, int sub, class Word, class Fixed>
[[gnu::always_inline]] inline bool sweep_column(
    const Rule& rule, const Fixed& fixed, const WordColumn<Word>& rows,
    const PlaneView<typename WordTraits<Word>::Element>& target, const Band& band, Index x) {
  using Traits = WordTraits<Word>;
  Word changed = Traits::zero();
  Window<Rule, WordColumn<Word>> window(rows, band.first);
  for (Index y = band.first; y < band.last; ++y) {
    const Word next = fixed.apply(window.template next<sub>(rule, rows, y), window.centre());
    Traits::store(target.row(y) + x, next);
    changed =
        ternary(changed, window.centre(), next, [](auto a, auto b, auto c) { return a | (b ^ c); });
    window.move_down();
  }
  return Traits::any(changed);
}

/// Applies sub-iteration `sub` of `rule` to the tiles of `band`, see Pass. The views come by value
/// because a store could otherwise be taken to change their fields.
template <class Rule, int sub, class Word>
[[gnu::always_inline]] inline std::uint64_t sweep_band(
    const Rule& rule, const typename WordTraits<Word>::Element* fixed,
    ConstPlaneView<typename WordTraits<Word>::Element> source,
    PlaneView<typename WordTraits<Word>::Element> target, Band band) {
  using Traits = WordTraits<Word>;
  const auto all_columns = [&](const auto& fixed_at) __attribute__((always_inline)) {
    std::uint64_t changed = 0;
    for (Index x = 0; x < source.row_elements; x += Traits::kElements) {
      const std::uint64_t columns = band.columns & band.columns_of(x, x + Traits::kElements);
      if (columns == 0) continue;
      const WordColumn<Word> rows = {source.data + x, source.stride};
      if (sweep_column<Rule, sub, Word>(rule, fixed_at(x), rows, target, band, x)) {
        changed |= columns;
      }
    }
    return changed;
  };
  if (fixed == nullptr) return all_columns([](Index) { return NothingFixed{}; });
  return all_columns([&](Index x) { return FixedPixels<Word>{Traits::load(fixed + x)}; });
}

}  // namespace thinbench::detail
