// Tests that run once for every rule, or once for every rule and border.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "thinbench/options.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {

inline std::vector<BuiltInRule> all_rules() {
  std::vector<BuiltInRule> rules;
  for (const RuleInfo& info : kRules) rules.push_back(info.rule);
  return rules;
}

using RuleAndBorder = std::tuple<BuiltInRule, Border>;

inline auto all_rules_and_borders() {
  return testing::Combine(testing::ValuesIn(all_rules()),
                          testing::Values(Border::background, Border::keep));
}

inline std::string rule_test_name(const testing::TestParamInfo<BuiltInRule>& tested) {
  return std::string(rule_name(tested.param));
}

inline std::string rule_and_border_test_name(const testing::TestParamInfo<RuleAndBorder>& tested) {
  const auto [rule, border] = tested.param;
  return std::string(rule_name(rule)) + "_border_" + std::string(border_name(border));
}

}  // namespace thinbench
