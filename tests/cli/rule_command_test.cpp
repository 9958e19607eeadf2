// thinbench rule: what it prints, writes and rejects.
#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "noise_image.hpp"
#include "rules/rule_file.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {
namespace {

using RuleCommand = NoiseImage;

TEST_F(RuleCommand, describes_rules_of_every_kind_in_one_line) {
  const Rule thin = Rule::named("thin");
  EXPECT_EQ(output_of("rule thin"),
            "thin: 2 sub-iterations, gates " + std::to_string(thin.gates(0)) + " + " +
                std::to_string(thin.gates(1)) + ", border background, limit none\n");
  put("two.json", R"({"hensel": "B3/S23", "max_iterations": 2, "border": "keep"})");
  for (const auto& [words, expected] : std::vector<std::pair<std::string, std::string>>{
           {"majority", R"(majority: 1 sub-iteration, gates \d+, border background, limit 1\n)"},
           {"guo_hall", R"(thin_guo_hall: 2 sub-iterations, gates \d+ \+ \d+, .* limit none\n)"},
           {"B3/S23 --optimise --border foreground",
            R"(B3/S23: 1 sub-iteration, gates \d+, border foreground, limit none\n)"},
           {"two.json", R"(two: 1 sub-iteration, gates \d+, border keep, limit 2\n)"}}) {
    const std::string text = output_of("rule " + words);
    EXPECT_TRUE(std::regex_match(text, std::regex(expected))) << text;
  }
}

TEST_F(RuleCommand, saves_a_rule_that_reads_back) {
  const std::string described =
      output_of("rule golay_l --save saved.json --border keep --max-iterations 4");
  EXPECT_TRUE(described.ends_with(", border keep, limit 4\n"));
  const RuleDescription saved = read_rule_file("saved.json");
  EXPECT_EQ(saved.name, "golay_l");
  EXPECT_TRUE(std::ranges::equal(saved.sub_iterations, Rule::named("golay_l").sub_iterations()));
  run("saved.json");
  expect_image("out.png", applied(Rule::named("golay_l"), {Border::keep, 4}));
}

TEST_F(RuleCommand, saves_built_in_rules_and_rules_without_a_limit) {
  output_of("rule thin_guo_hall --save saved.json");
  run("saved.json");
  expect_image("out.png", applied(Rule::guo_hall));
  output_of("rule B3/S23 --save saved.json");
  EXPECT_EQ(read_rule_file("saved.json").max_iterations, kUnlimited);
}

TEST_F(RuleCommand, lists_the_named_rules) {
  std::istringstream lines(output_of("rule --list"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("name ", 0), 0U);
  for (const NamedRule& rule : named_rules()) {
    std::getline(lines, line);
    const std::string limit =
        rule.max_iterations == kUnlimited ? "none" : std::to_string(rule.max_iterations);
    const std::regex columns(std::string(rule.name) + " +" +
                             std::to_string(rule.sub_iterations.size()) + " +" + limit + " +" +
                             std::string(border_name(rule.border)) + " +\\S.*");
    EXPECT_TRUE(std::regex_match(line, columns)) << line;
    expect_holds(line, std::string(rule.description));
    expect_holds(line, std::string(rule.source));
  }
}

TEST_F(RuleCommand, rejects_rules_without_tables_and_wrong_words) {
  expect_rejected({
      {2, "rule thin_mb2 --save a.json", {"thin_mb2 does not depend on 3 x 3"}},
      {2, "rule", {"rule needs RULE, or --list"}},
      {2, "rule majority --list", {"--list takes no RULE"}},
      {2, "rule majority in.png out.png", {"'in.png' was not expected"}},
      {1, "rule majority --save /absent/rule.json", {"'/absent/rule.json'", "no directory"}},
  });
}

}  // namespace
}  // namespace thinbench
