// A pass applies one sub-iteration of a rule to a band of rows; an engine provides one pass for
// every sub-iteration of every rule. Here: the tables through which the catalogue reaches them.
#pragma once

#include <utility>

#include "dispatch/isa.hpp"
#include "image/plane_view.hpp"
#include "thinning/rules.hpp"

namespace thinbench::detail {

/// What a rule that is not fixed at compile time consists of, such as the weights of a net.
struct RuleModel;

/// A band of rows, of which only some tiles need a visit. A row is cut into at most 64 columns of
/// `column_elements` elements; bit i of `columns` asks for column i.
struct Band {
  Index first;  // row
  Index last;   // row after the last
  std::uint64_t columns;
  Index column_elements;
  Index row_elements;  // the last column may be narrower

  /// Bits of the columns that elements [from, to) touch.
  [[nodiscard]] std::uint64_t columns_of(Index from, Index to) const {
    const Index low = from / column_elements;
    const Index high = (to - 1) / column_elements;
    return (~std::uint64_t{0} >> (63 - (high - low))) << low;
  }
};

/// Writes the tiles of `band` in `target` from `source` and what surrounds them; other tiles of the
/// band may be written, too, with the pixels that the rule gives them. Returns the columns that
/// changed, among those asked for. The planes have one size and do not overlap; nothing outside the
/// rows is written. `model` is nullptr for rules that need none.
template <class T>
using Pass = std::uint64_t (*)(const RuleModel* model, const ConstPlaneView<T>& source,
                               const PlaneView<T>& target, const Band& band);

/// A pass that also sees what the last step changed: `previous` is the image before it, light
/// everywhere before the first. Otherwise as Pass, for packed pixels.
using ChangePass = std::uint64_t (*)(const RuleModel* model, const ConstBitPlaneView& previous,
                                     const ConstBitPlaneView& source, const BitPlaneView& target,
                                     const Band& band);

/// For engines that work row by row: calls `row(y, from, to)` for each row of the band and each run
/// of neighbouring columns, and collects the columns in which it returned true.
template <class Row>
[[gnu::always_inline]] inline std::uint64_t for_each_run(const Band& band, const Row& row) {
  std::uint64_t changed = 0;
  for (std::uint64_t left = band.columns; left != 0;) {
    const int begin = __builtin_ctzll(left);
    const std::uint64_t gap = ~left >> begin;
    const int length = gap == 0 ? 64 - begin : __builtin_ctzll(gap);
    const std::uint64_t run = (~std::uint64_t{0} >> (64 - length)) << begin;
    left &= ~run;
    const Index from = begin * band.column_elements;
    const Index end = (begin + length) * band.column_elements;
    const Index to = end < band.row_elements ? end : band.row_elements;
    bool any = false;
    for (Index y = band.first; y < band.last; ++y) any = row(y, from, to) || any;
    if (any) changed |= run;
  }
  return changed;
}

template <class... Rules>
consteval int step_count(RuleList<Rules...>) {
  return (Rules::kSubIterations + ... + 0);
}

/// Where the sub-iterations of `Rule` begin in every table.
template <class Rule, class... Rules>
consteval int first_step(RuleList<Rules...>) {
  int step = 0;
  bool found = false;
  ((found = found || __is_same(Rule, Rules), step += found ? 0 : Rules::kSubIterations), ...);
  return step;
}

/// The functions of one engine: all rules in the order of AllRules, each with all its
/// sub-iterations.
template <class Function>
struct StepTable {
  Function passes[step_count(AllRules{})];
};

template <class T>
using PassTable = StepTable<Pass<T>>;

namespace internal {

template <class Engine, class Rule, class Function, int... subs>
consteval void fill_rule(StepTable<Function>& table, int& step,
                         std::integer_sequence<int, subs...>) {
  const auto pass_of = []<int sub>() -> Function {
    if constexpr (requires { &Engine::template pass<Rule, sub>; }) {
      return &Engine::template pass<Rule, sub>;
    } else {
      return nullptr;  // the engine does not know rules of this kind
    }
  };
  ((table.passes[step++] = pass_of.template operator()<subs>()), ...);
}

template <class Function, class Engine, class... Rules>
consteval StepTable<Function> fill_table(RuleList<Rules...>) {
  StepTable<Function> table{};
  int step = 0;
  (fill_rule<Engine, Rules>(table, step, std::make_integer_sequence<int, Rules::kSubIterations>{}),
   ...);
  return table;
}

}  // namespace internal

/// The table of an engine: a struct with `template <class Rule, int sub> static ... pass`.
template <class Function, class Engine>
consteval StepTable<Function> make_step_table() {
  return detail::fill_table<Function, Engine>(AllRules{});
}

/// The same for an engine over planes of its `Element`.
template <class Engine>
consteval PassTable<typename Engine::Element> make_pass_table() {
  return make_step_table<Pass<typename Engine::Element>, Engine>();
}

/// Engines that are compiled once, for the baseline.
struct ScalarPasses {
  static const PassTable<std::uint8_t> kLut;
  static const PassTable<std::uint8_t> kLutSliding;
  static const PassTable<std::uint64_t> kBitpacked;
};

/// Engines that are compiled once for every instruction-set level.
template <Isa isa>
struct IsaPasses {
  static const PassTable<std::uint8_t> kAutovec;
  static const PassTable<std::uint8_t> kSimdBytes;
  static const PassTable<std::uint64_t> kSimdBitpacked;
};

}  // namespace thinbench::detail
