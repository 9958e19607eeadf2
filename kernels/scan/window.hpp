// Scans of columns of words from the top down, which keep three rows in registers: each word is
// loaded once, with its west and east neighbours for the bits that cross words. One template for
// every word type (packed pixels or byte lanes, scalar or SIMD).
#pragma once

#include <utility>

#include "rules/parallel_rules.hpp"
#include "simd/word.hpp"

namespace thinbench::detail {

/// A word of a row, and the same pixels shifted by one: their west and east neighbours.
template <class Word>
struct RowTriple {
  Word west, centre, east;
};

template <class Word>
[[gnu::always_inline]] inline RowTriple<Word> load_row(
    const typename WordTraits<Word>::Element* from) {
  using Traits = WordTraits<Word>;
  const Word centre = Traits::load(from);
  return {Traits::west(centre, from), centre, Traits::east(centre, from)};
}

template <class Word>
[[gnu::always_inline]] inline Neighbourhood<Word> neighbourhood(const RowTriple<Word>& above,
                                                                const RowTriple<Word>& here,
                                                                const RowTriple<Word>& below) {
  return {here.centre, here.east,  above.east,   above.centre, above.west,
          here.west,   below.west, below.centre, below.east};
}

template <class Word>
[[gnu::always_inline]] inline Cross<Word> cross(Word above, const RowTriple<Word>& here,
                                                Word below) {
  return {here.centre, here.east, above, here.west, below};
}

/// The features of a word and its neighbours. `west2` and `east2` are the pixels two columns away.
template <class Rule, class Word>
[[gnu::always_inline]] inline RowTriple<Word> feature_triple(const RowTriple<Word>& above,
                                                             const RowTriple<Word>& here,
                                                             const RowTriple<Word>& below,
                                                             Word west2, Word east2) {
  const RowTriple<Word> to_west = {west2, here.west, here.centre};
  const RowTriple<Word> to_east = {here.centre, here.east, east2};
  return {Rule::feature(cross(above.west, to_west, below.west)),
          Rule::feature(cross(above.centre, here, below.centre)),
          Rule::feature(cross(above.east, to_east, below.east))};
}

/// The sliding window of rows around row y in a scan from the top down. `Rows` accesses the
/// engine's memory: `row(y)` and, for two-stage rules, `features<Rule>(y, above, here, below)`.
template <class Rule, class Rows>
class Window {
 public:
  using Row = decltype(std::declval<const Rows&>().row(0));

  [[gnu::always_inline]] Window(const Rows& rows, Index first)
      : above_(rows.row(first - 1)), here_(rows.row(first)) {}

  [[nodiscard, gnu::always_inline]] auto centre() const { return here_.centre; }

  /// The new pixels of row y. Call once per row, for consecutive rows, with move_down() between.
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

/// Two-stage rules: a second window holds the features, one row ahead.
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

/// Rows of a column of words of a plane. All accesses to rows have at(), which makes one whose row
/// 0 begins at `from`; `stride` is in elements.
template <class AnyWord>
struct PlaneRows {
  using Word = AnyWord;
  using Traits = WordTraits<Word>;
  using Element = typename Traits::Element;
  static constexpr bool kInPlace = false;

  const Element* data;
  Index stride;

  [[gnu::always_inline]] static PlaneRows at(const Element* from, Index stride) {
    return {from, stride};
  }

  [[gnu::always_inline]] RowTriple<Word> row(Index y) const {
    return load_row<Word>(data + y * stride);
  }

  template <class Rule>
  [[gnu::always_inline]] RowTriple<Word> features(Index y, const RowTriple<Word>& above,
                                                  const RowTriple<Word>& here,
                                                  const RowTriple<Word>& below) const {
    const auto* from = data + y * stride;
    return feature_triple<Rule>(above, here, below, Traits::west2(here.centre, from),
                                Traits::east2(here.centre, from));
  }
};

}  // namespace thinbench::detail
