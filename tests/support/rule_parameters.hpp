// Tests that run once for every rule, or once for every rule and border.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "harness/splitmix64.hpp"
#include "techniques/study_rules.hpp"

namespace thinbench {

/// Those of the product and of the study.
inline std::vector<Rule> all_rules() {
  std::vector<Rule> rules;
  for (const RuleInfo& info : kRules) rules.emplace_back(info.rule);
  for (const auto& info : detail::study::kStudyRules) {
    rules.push_back(detail::study::make_rule(info.rule));
  }
  return rules;
}

inline std::string rule_test_name(const testing::TestParamInfo<Rule>& tested) {
  return std::string(tested.param.name());
}

/// Two sub-iterations that add pixels in one window of ten.
inline Rule adding_rule() {
  const auto table = [](std::uint64_t seed) {
    return make_window_table([seed](std::size_t window) {
      return (window >> WindowTable::kCentre & 1) != 0 || splitmix64(seed, window) % 10 == 0;
    });
  };
  return Rule(std::array{table(1), table(2)});
}

/// Table 1 of the paper without one hidden neuron, which decides otherwise than any rule.
inline TwoLayerWeights damaged_net() {
  TwoLayerWeights weights = kPaperTwoLayer;
  weights.output.weight[0] = 0;
  return weights;
}

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
inline void PrintTo(const Rule& rule, std::ostream* out) {
  *out << rule.name();
}

struct RuleAndBorder {
  std::string name;
  Rule rule;
  Border border;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
inline void PrintTo(const RuleAndBorder& tested, std::ostream* out) {
  *out << tested.name << ", border " << border_name(tested.border);
}

/// Adds a rule with every border that it can have.
inline void add_with_borders(const std::string& name, const Rule& rule,
                             std::vector<RuleAndBorder>& all) {
  for (const Border border : {Border::background, Border::keep, Border::foreground}) {
    if (border == Border::foreground && rule.sub_iterations().empty()) continue;
    all.push_back({name, rule, border});
  }
}

/// Built-in rules and some of every other kind, which end without a limit, with every border that
/// they can have.
inline std::vector<RuleAndBorder> rules_and_borders() {
  std::vector<RuleAndBorder> all;
  const auto add = [&](const std::string& name, const Rule& rule) {
    add_with_borders(name, rule, all);
  };
  for (const RuleInfo& info : kRules) add(std::string(info.name), info.rule);
  for (const char* name : {"dilate", "erode", "golay_l"}) add(name, Rule::named(name));
  add("adding_tables", adding_rule());
  add("damaged_net", Rule::from_net(damaged_net(), Activation::sigmoid));
  return all;
}

inline auto all_rules_and_borders() {
  return testing::ValuesIn(rules_and_borders());
}

inline std::string rule_and_border_test_name(const testing::TestParamInfo<RuleAndBorder>& tested) {
  return tested.param.name + "_border_" + std::string(border_name(tested.param.border));
}

}  // namespace thinbench
