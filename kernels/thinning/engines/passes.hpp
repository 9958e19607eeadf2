// The interface of engines: functions that apply a sub-iteration of a rule to a band of rows, in
// tables by rule.
#pragma once

#include <cstddef>
#include <span>

#include "image/plane_view.hpp"
#include "thinbench/rule.hpp"
#include "thinning/rules.hpp"
#include "thinning/runtime_rule.hpp"

namespace thinbench::detail {

/// A band of rows, cut into at most 64 tiles: columns of `column_elements` elements. Column i must
/// be computed where bit i of `columns` is set.
struct Band {
  Index first;  // row
  Index last;   // row after the last
  std::uint64_t columns;
  Index column_elements;
  Index row_elements;  // the last column may be narrower

  /// The columns with elements [from, to), as bits.
  [[nodiscard]] std::uint64_t columns_of(Index from, Index to) const {
    const Index low = from / column_elements;
    const Index high = (to - 1) / column_elements;
    return (~std::uint64_t{0} >> (63 - (high - low))) << low;
  }
};

/// Applies a sub-iteration to the columns of `band` that must be computed; may write the others,
/// too, with correct pixels. Returns which of the former changed. The planes have one size and do
/// not overlap; no other rows are written. `rule` is nullptr for rules that are fixed at compile
/// time. `fixed` is nullptr or a row of elements with a 1 for every pixel that must not change.
template <class T>
using Pass = std::uint64_t (*)(const RuntimeRule* rule, const T* fixed,
                               const ConstPlaneView<T>& source, const PlaneView<T>& target,
                               const Band& band);

/// A Pass on packed pixels that also sees what the last sub-iteration changed: `previous` is the
/// image before it, or background before the first.
using ChangePass = std::uint64_t (*)(const RuntimeRule* rule, const std::uint64_t* fixed,
                                     const ConstBitPlaneView& previous,
                                     const ConstBitPlaneView& source, const BitPlaneView& target,
                                     const Band& band);

/// For engines that work row by row: calls `row(y, from, to)` for each row of the band and each run
/// of adjacent columns, and returns the columns of runs where it returned true.
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

inline constexpr int kMaxSubIterations = 4;

/// A function per sub-iteration of a rule. Empty where an engine does not support the rule.
template <class Function>
struct Cycle {
  Function steps[kMaxSubIterations] = {};
  int count = 0;

  [[nodiscard]] constexpr bool empty() const { return count == 0; }
  [[nodiscard]] constexpr std::span<const Function> functions() const {
    return {steps, static_cast<std::size_t>(count)};
  }
};

/// One entry per rule.
template <class T>
struct ByRule {
  T entries[kRules.size()] = {};

  constexpr const T& operator[](Rule rule) const { return entries[static_cast<std::size_t>(rule)]; }
  constexpr T& operator[](Rule rule) { return entries[static_cast<std::size_t>(rule)]; }
};

/// `Engine::template pass<Type, sub>` for every sub-iteration of every parallel rule that the
/// engine supports.
template <class Function, class Engine>
consteval ByRule<Cycle<Function>> cycles_by_rule() {
  ByRule<Cycle<Function>> table;
  for_each_parallel_rule([&]<class Type>(Rule rule) {
    static_assert(Type::kSubIterations <= kMaxSubIterations);
    const auto add = [&]<int sub>() {
      if constexpr (requires { &Engine::template pass<Type, sub>; }) {
        table[rule].steps[sub] = &Engine::template pass<Type, sub>;
        table[rule].count = Type::kSubIterations;
      }
    };
    [&]<int... subs>(std::integer_sequence<int, subs...>) {
      (add.template operator()<subs>(), ...);
    }
    (std::make_integer_sequence<int, Type::kSubIterations>{});
  });
  return table;
}

template <class T>
using PassesByRule = ByRule<Cycle<Pass<T>>>;

template <class Engine>
consteval PassesByRule<typename Engine::Element> passes_by_rule() {
  return cycles_by_rule<Pass<typename Engine::Element>, Engine>();
}

/// Compiled once, for the baseline. The last three take a RuntimeRule.
struct ScalarPasses {
  static const PassesByRule<std::uint8_t> kLut;
  static const PassesByRule<std::uint8_t> kLutSliding;
  static const PassesByRule<std::uint64_t> kBitpacked;
  static const Pass<std::uint8_t> kRuntimeLut;
  static const Pass<std::uint8_t> kRuntimeLutSliding;
  static const Pass<std::uint64_t> kRuntimeBitpacked;
};

/// Compiled for every ISA, see simd.cpp and autovec.cpp.
struct SimdPasses {
  PassesByRule<std::uint8_t> bytes;
  PassesByRule<std::uint64_t> bitpacked;
  Pass<std::uint64_t> runtime_bitpacked;  // takes a RuntimeRule
};
struct AutovecPasses {
  PassesByRule<std::uint8_t> bytes;
};

}  // namespace thinbench::detail
