// The interface of the techniques that thin: passes, which are functions that apply one
// sub-iteration of a rule to a band of rows, and tables of passes by rule.
#pragma once

#include <cstddef>
#include <span>

#include "core/plane_view.hpp"
#include "engines/band.hpp"
#include "rules/parallel_rules.hpp"
#include "scan/built_in.hpp"
#include "techniques/byte_planes.hpp"

namespace thinbench::detail {

/// Applies one sub-iteration to the active columns of `band` and returns which of them changed. May
/// also write the correct pixels of inactive columns; writes no other rows. The planes have equal
/// sizes and do not overlap. `fixed` is nullptr or a row with a 1 for every pixel that must not
/// change. Thread-safe for different bands.
template <class T>
using Pass = std::uint64_t (*)(const T* fixed, const ConstPlaneView<T>& source,
                               const PlaneView<T>& target, const Band& band);

/// For engines that work row by row: calls `row(y, from, to)` for each run of active columns and
/// each row of the band. Returns the columns of the runs for which a call returned true.
template <class Row>
[[gnu::always_inline]] inline std::uint64_t for_each_run(const Band& band, const Row& row) {
  std::uint64_t changed = 0;
  for (std::uint64_t rest = band.columns; rest != 0;) {
    const int begin = __builtin_ctzll(rest);
    const std::uint64_t gap = ~rest >> begin;
    const int length = gap == 0 ? 64 - begin : __builtin_ctzll(gap);
    const std::uint64_t run = (~std::uint64_t{0} >> (64 - length)) << begin;
    rest &= ~run;
    const Index from = begin * band.column_elements;
    const Index end = (begin + length) * band.column_elements;
    const Index to = end < band.row_elements ? end : band.row_elements;
    bool any = false;
    for (Index y = band.first; y < band.last; ++y) any = row(y, from, to) || any;
    if (any) changed |= run;
  }
  return changed;
}

/// The functions of a rule's sub-iterations. Empty if an engine does not support the rule.
template <class Function>
struct SubIterations {
  Function entries[kMaxSubIterations] = {};
  int count = 0;

  [[nodiscard]] constexpr bool empty() const { return count == 0; }
  [[nodiscard]] constexpr std::span<const Function> functions() const {
    return {entries, static_cast<std::size_t>(count)};
  }
};

/// The table of `Engine::template pass<Type, sub>` for all parallel rules that the engine supports.
template <class Function, class Engine>
consteval ByRule<SubIterations<Function>> sub_iterations_by_rule() {
  ByRule<SubIterations<Function>> table;
  for_each_parallel_rule([&]<class Type>(BuiltInRule rule) {
    static_assert(Type::kSubIterations <= kMaxSubIterations);
    const auto add = [&]<int sub>() {
      if constexpr (requires { &Engine::template pass<Type, sub>; }) {
        table[rule].entries[sub] = &Engine::template pass<Type, sub>;
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
using PassesByRule = ByRule<SubIterations<Pass<T>>>;

template <class Engine>
consteval PassesByRule<typename Engine::Element> passes_by_rule() {
  return sub_iterations_by_rule<Pass<typename Engine::Element>, Engine>();
}

/// Compiled once, for the baseline.
struct LutPasses {
  static const PassesByRule<std::uint8_t> kLut;
  static const PassesByRule<std::uint8_t> kLutSliding;
};

/// Compiled per ISA.
struct AutovecPasses {
  PassesByRule<std::uint8_t> bytes;
};
struct SimdPasses {
  PassesByRule<std::uint8_t> bytes;
  PassesByRule<std::uint64_t> words;
};

/// Built-in rules on words of 64 pixels in general registers. Compiled once, for the baseline.
extern const PassesByRule<std::uint64_t> kScalarPasses;

/// The interpreter on such words. Executes SlotNetworks that are not ternary, on Layout::words.
extern const ScanFunction kScalarInterpreter;

}  // namespace thinbench::detail
