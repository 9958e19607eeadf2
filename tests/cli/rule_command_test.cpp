// thinbench rule: what it prints, writes and rejects.
#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "noise_fixture.hpp"
#include "rules/rule_file.hpp"
#include "thinbench/named_rules.hpp"

namespace thinbench {
namespace {

class RuleCommand : public NoiseFixture {};

std::string described(const std::vector<std::string>& words) {
  std::vector<std::string> all = words;
  all.insert(all.begin(), "rule");
  const ProgramRun ran = run_with(all);
  EXPECT_EQ(ran.status, 0) << ran.err;
  return ran.out;
}

TEST_F(RuleCommand, describes_rules_of_every_kind_in_one_line) {
  const Rule thin = Rule::named("thin");
  EXPECT_EQ(described({"thin"}), "thin: 2 sub-iterations, gates " + std::to_string(thin.gates(0)) +
                                     " + " + std::to_string(thin.gates(1)) +
                                     ", border background, limit none\n");
  const auto expect_description = [](const std::vector<std::string>& words, const char* line) {
    const std::string text = described(words);
    EXPECT_TRUE(std::regex_match(text, std::regex(line))) << text;
  };
  expect_description({"majority"},
                     "majority: 1 sub-iteration, gates \\d+, border background, limit 1\n");
  expect_description(
      {"guo_hall"},
      R"(thin_guo_hall: 2 sub-iterations, gates \d+ \+ \d+, border background, limit none\n)");
  expect_description({"B3/S23", "--optimise", "--border", "foreground"},
                     "B3/S23: 1 sub-iteration, gates \\d+, border foreground, limit none\n");
  const std::string file =
      directory.with("two.json", R"({"hensel": "B3/S23", "max_iterations": 2, "border": "keep"})");
  expect_description({file}, "two: 1 sub-iteration, gates \\d+, border keep, limit 2\n");
}

TEST_F(RuleCommand, saves_a_rule_that_reads_back) {
  const std::string file = directory.file("saved.json");
  const std::vector<std::string> more = {"--border", "keep", "--max-iterations", "4"};
  std::vector<std::string> save = {"golay_l", "--save", file};
  save.insert(save.end(), more.begin(), more.end());
  EXPECT_TRUE(described(save).ends_with(", border keep, limit 4\n"));
  const RuleDescription saved = read_rule_file(file);
  EXPECT_EQ(saved.name, "golay_l");
  EXPECT_TRUE(std::ranges::equal(saved.sub_iterations, Rule::named("golay_l").sub_iterations()));
  EXPECT_EQ(saved.border, Border::keep);
  EXPECT_EQ(saved.max_iterations, 4);
  run("golay_l", more);
  const ByteImage direct = read_grey(out);
  run(file);
  EXPECT_TRUE(wrote(direct));
}

TEST_F(RuleCommand, saves_built_in_rules_and_rules_without_a_limit) {
  const std::string file = directory.file("saved.json");
  static_cast<void>(described({"thin_guo_hall", "--save", file}));
  run(file);
  EXPECT_TRUE(wrote(applied(Rule::guo_hall)));
  static_cast<void>(described({"B3/S23", "--save", file}));
  EXPECT_EQ(read_rule_file(file).max_iterations, kUnlimited);
}

TEST_F(RuleCommand, lists_the_named_rules) {
  std::istringstream lines(described({"--list"}));
  std::string head;
  std::getline(lines, head);
  EXPECT_EQ(head.rfind("name ", 0), 0U);
  for (const NamedRule& rule : named_rules()) {
    std::string line;
    std::getline(lines, line);
    const std::string limit =
        rule.max_iterations == kUnlimited ? "none" : std::to_string(rule.max_iterations);
    const std::regex columns(std::string(rule.name) + " +" +
                             std::to_string(rule.sub_iterations.size()) + " +" + limit + " +" +
                             std::string(border_name(rule.border)) + " +\\S.*");
    EXPECT_TRUE(std::regex_match(line, columns)) << line;
    EXPECT_NE(line.find(rule.description), std::string::npos) << line;
    EXPECT_NE(line.find(rule.source), std::string::npos) << line;
  }
}

TEST_F(RuleCommand, rules_without_tables_are_rejected) {
  for (const std::string rule : {"thin_spta", "thin_mb2", "skeleton_scan"}) {
    EXPECT_EQ(failure_of({"rule", rule, "--save", directory.file("a.json")}, 2),
              rule + " is no function of 3 x 3 pixels and has no tables");
  }
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

TEST_F(RuleCommand, wrong_command_lines_are_rejected) {
  EXPECT_EQ(failure_of({"rule"}, 2), "rule needs RULE, or --list");
  EXPECT_EQ(failure_of({"rule", "majority", "--list"}, 2), "--list takes no RULE");
  EXPECT_EQ(failure_of({"rule", "majority", in, out}, 2).find("'" + in + "' was not expected"), 0U);
  EXPECT_EQ(failure_of({"rule", "majorty"}, 2),
            "no rule is named 'majorty'; did you mean 'majority'?");
  EXPECT_EQ(failure_of({"rule", "majority", "--save", "/absent/rule.json"}, 1),
            "cannot write '/absent/rule.json': there is no directory '/absent'");
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

}  // namespace
}  // namespace thinbench
