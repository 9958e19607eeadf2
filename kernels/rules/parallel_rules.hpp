// The parallel thinning rules: each sub-iteration computes all pixels from the same input. A file
// in rules/built_in/ defines one rule as an expression over any word type, or by its circuits in
// circuits.hpp there, and says which rule it is:
//   template <>
//   struct RuleType<BuiltInRule::guo_hall> { using Type = GuoHall; };
#pragma once

#include <type_traits>
#include <utility>

#include "rules/all_rules.hpp"  // generated: includes every file in rules/built_in/
#include "thinbench/rule.hpp"

namespace thinbench::detail {

/// Calls `body.template operator()<Type>(rule)` for each parallel rule, in catalogue order; `rule`
/// is a std::integral_constant.
template <class Body>
constexpr void for_each_parallel_rule(const Body& body) {
  const auto visit = [&]<std::size_t i>() {
    constexpr BuiltInRule rule = kRules[i].rule;
    if constexpr (requires { typename RuleType<rule>::Type; }) {
      body.template operator()<typename RuleType<rule>::Type>(
          std::integral_constant<BuiltInRule, rule>{});
    }
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (visit.template operator()<i>(), ...);
  }
  (std::make_index_sequence<kRules.size()>{});
}

}  // namespace thinbench::detail
