// Scans of built-in rules: templates over rules and accesses to rows. In a namespace of the ISA, as
// functions of one word type differ between ISAs.
#pragma once

#include <utility>

#include "scan/built_in.hpp"
#include "scan/window.hpp"

namespace thinbench::detail {
inline namespace THINBENCH_ISA {

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

}  // namespace THINBENCH_ISA
}  // namespace thinbench::detail
