// Scans of columns of words from the top down, which keep three rows in registers: each word is
// loaded once, with its west and east neighbours for the bits that cross words. One template for
// every word type (packed pixels or byte lanes, scalar or SIMD).
#pragma once

#include <utility>

#include "rules/parallel_rules.hpp"
#include "scan/built_in.hpp"
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

/// Policies that restore fixed pixels, those that must not change: none, or the pixels of a mask.
struct NoFixedPixels {
  template <class Word>
  [[gnu::always_inline]] static Word apply(Word next, Word) {
    return next;
  }
};
template <class Word>
struct FixedPixels {
  Word mask;
  /// Built-in rules only remove pixels, so one OR restores the fixed ones.
  [[gnu::always_inline]] Word apply(Word next, Word before) const {
    return ternary(next, before, mask, [](auto a, auto b, auto c) { return a | (b & c); });
  }
};

struct NoPrefetch {
  [[gnu::always_inline]] void prefetch_line() {}
};

/// A built-in rule on a column, band by band. `Rows` is an access to rows; in place, target and
/// source are the same rows. Something else may be prefetched line by line.
template <class Rule, int sub, class Rows, class Fixed, class Prefetch>
[[gnu::always_inline]] inline std::uint64_t scan_bands(const ColumnScan& scan, const Fixed& fixed,
                                                       Prefetch& prefetch) {
  using Word = typename Rows::Word;
  using Traits = WordTraits<Word>;
  using Element = typename Traits::Element;
  constexpr auto bytes = static_cast<Index>(sizeof(Element));
  const Index stride = Rows::kInPlace ? Traits::kElements : scan.source_stride / bytes;
  const Index target_stride = Rows::kInPlace ? stride : scan.target_stride / bytes;
  auto* target = static_cast<Element*>(scan.target);
  const Element* source = Rows::kInPlace ? target : static_cast<const Element*>(scan.source);
  Window<Rule, Rows> window(Rows::at(source, stride), 0);
  std::uint64_t changed_bands = 0;
  std::uint64_t band = 1;
  for (Index rest = scan.rows; rest > 0; rest -= scan.band_rows, band <<= 1) {
    const Index rows = rest < scan.band_rows ? rest : scan.band_rows;
    Word changed = Traits::zero();
    for (Index y = 0; y < rows; ++y) {
      if constexpr (Rows::kInPlace) source = target;
      const Word next = fixed.apply(window.template next<sub>(Rule{}, Rows::at(source, stride), 0),
                                    window.centre());
      Traits::store(target, next);
      prefetch.prefetch_line();
      changed = ternary(changed, window.centre(), next,
                        [](auto a, auto b, auto c) { return a | (b ^ c); });
      window.move_down();
      source += stride;
      target += target_stride;
    }
    changed_bands |= Traits::any(changed) ? band : 0;
  }
  return changed_bands;
}

/// The same as a ScanFunction. Static, because ISAs may share a type of words.
template <class Rule, int sub, class Rows>
static std::uint64_t scan_built_in(const void*, const ColumnScan& shared) {
  const ColumnScan scan = shared;  // a local copy, which stores cannot alias
  using Traits = WordTraits<typename Rows::Word>;
  NoPrefetch none;
  if (scan.fixed == nullptr) return scan_bands<Rule, sub, Rows>(scan, NoFixedPixels{}, none);
  const auto* fixed = static_cast<const typename Traits::Element*>(scan.fixed);
  return scan_bands<Rule, sub, Rows>(scan, FixedPixels<typename Rows::Word>{Traits::load(fixed)},
                                     none);
}

/// All iterations of a built-in rule on rows in place, see RepeatFunction.
template <class Rule, class Rows, class Fixed>
[[gnu::always_inline]] inline int repeat_scans(const ColumnScan& scan, int max_iterations,
                                               const Fixed& fixed, Prefetcher& shared) {
  Prefetcher prefetcher = shared;  // a local copy, which stores cannot alias
  int iterations = 0;
  bool changed = true;
  while (changed && iterations < max_iterations) {
    changed = [&]<int... subs>(std::integer_sequence<int, subs...>) __attribute__((always_inline)) {
      std::uint64_t any = 0;
      ((any |= scan_bands<Rule, subs, Rows>(scan, fixed, prefetcher)), ...);
      return any != 0;
    }
    (std::make_integer_sequence<int, Rule::kSubIterations>{});
    ++iterations;
  }
  shared = prefetcher;
  return iterations;
}

template <class Rule, class Rows>
static int repeat_built_in(const ColumnScan& shared, int max_iterations, Prefetcher& prefetcher) {
  const ColumnScan scan = shared;
  using Traits = WordTraits<typename Rows::Word>;
  if (scan.fixed == nullptr) {
    return repeat_scans<Rule, Rows>(scan, max_iterations, NoFixedPixels{}, prefetcher);
  }
  const auto* fixed = static_cast<const typename Traits::Element*>(scan.fixed);
  return repeat_scans<Rule, Rows>(
      scan, max_iterations, FixedPixels<typename Rows::Word>{Traits::load(fixed)}, prefetcher);
}

/// The scan functions of a rule.
template <class Rule, class Rows>
consteval ScanFunctions scan_functions() {
  ScanFunctions functions{};
  [&]<int... subs>(std::integer_sequence<int, subs...>) {
    ((functions[subs] = &scan_built_in<Rule, subs, Rows>), ...);
  }
  (std::make_integer_sequence<int, Rule::kSubIterations>{});
  return functions;
}

/// A table of `make.template operator()<Type>()` for all parallel rules.
template <class T, class Make>
consteval ByRule<T> for_all_rules(const Make& make) {
  ByRule<T> table;
  for_each_parallel_rule(
      [&]<class Type>(BuiltInRule rule) { table[rule] = make.template operator()<Type>(); });
  return table;
}

template <class Rows>
consteval ByRule<ScanFunctions> scan_functions_by_rule() {
  return for_all_rules<ScanFunctions>([]<class Rule>() { return scan_functions<Rule, Rows>(); });
}

template <class Rows>
consteval ByRule<RepeatFunction> repeat_functions_by_rule() {
  return for_all_rules<RepeatFunction>([]<class Rule>() { return &repeat_built_in<Rule, Rows>; });
}

}  // namespace thinbench::detail
