// Rules of every kind: names, notations and files, as `thinbench run` applies them and `thinbench
// rule` describes, saves and lists them.
#include <algorithm>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include "harness/test_images.hpp"
#include "rules/rule_file.hpp"
#include "support/made_image.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

/// A file with noise, to which commands apply rules.
class Rules : public Commands {
 protected:
  Rules() { write_grey("in.png", noise().view()); }

  /// 0 and 255.
  static ByteImage noise() {
    return mapped(noise_image(203, 70, 50, 4, 7), [](int pixel) { return pixel != 0 ? 255 : 0; });
  }
  static ByteImage applied(const Rule& rule, const Thinning& thinning = {}) {
    return thinned(rule, noise(), thinning);
  }
  /// Foreground is bright, so that nothing is remarked.
  static std::string run(const std::string& rule_and_options) {
    return output_of("run " + rule_and_options + " in.png out.png --foreground bright");
  }
};

const Rule kLife(table_from_hensel("B3/S23"));

TEST_F(Rules, every_kind_of_rule_is_applied_and_prints_its_name) {
  const std::string life = R"({"name": "twice", "hensel": "B3/S23", "max_iterations": 2, )"
                           R"("border": "keep"})";
  put("two.json", life);
  put("plain", R"({"hensel": "B/S", "max_iterations": 1})");
  struct Case {
    std::string words, name;
    ByteImage expected;
  };
  const Case cases[] = {
      {"majority", "majority", applied(Rule::named("majority"))},
      {"guo_hall", "thin_guo_hall", applied(Rule::guo_hall)},
      {"zhang_suen --border foreground", "thin_zhang_suen",
       applied(Rule::zhang_suen, {.border = Border::foreground})},
      {"B3/S23 --max-iterations 5", "B3/S23", applied(kLife, {.max_iterations = 5})},
      {"b2-as12 --max-iterations 1", "b2-as12",
       applied(Rule(table_from_hensel("B2-a/S12")), {.max_iterations = 1})},
      {"two.json", "twice", applied(kLife, {Border::keep, 2})},
      {"two.json --border foreground --max-iterations 3", "twice",
       applied(kLife, {Border::foreground, 3})},
      {"plain", "plain", ByteImage(203, 70)},
      {"bridge --isa baseline --threads 2", "bridge", applied(Rule::named("bridge"))},
      {"erode --optimise", "erode", applied(Rule::named("erode"))},
  };
  for (const auto& [words, name, expected] : cases) {
    const std::string line = run(words);
    EXPECT_TRUE(std::regex_match(
        line, std::regex(name + R"(: 203 x 70, \d+ iterations?, \d+ foreground pixels before, )"
                                R"(\d+ after, \d+\.\d{3} ms\n)")))
        << line;
    expect_image("out.png", expected);
  }
  EXPECT_EQ(names(), (Names{"in.png", "out.png", "plain", "two.json"}));
}

TEST_F(Rules, the_scan_has_the_border_background_or_keep) {
  for (const Border border : {Border::background, Border::keep}) {
    ByteImage expected = noise();
    midpoint_scan(expected.view(), expected.view(), {}, border);
    run("midpoint_scan --border " + std::string(border_name(border)));
    expect_image("out.png", expected);
  }
  expect_rejected({2,
                   "run midpoint_scan --border foreground in.png no.png",
                   {"midpoint_scan: border: expected background or keep, got foreground"}});
}

TEST_F(Rules, names_notations_and_files_that_are_no_rules_are_rejected) {
  const std::string limit =
      ": this rule adds and removes pixels, so it may never end; it needs a limit";
  put("life.json", R"({"hensel": "B3/S23"})");
  put("wrong.json", R"({"hensel": "B3/S9"})");
  put("huge.json", "{");
  fs::resize_file("huge.json", std::uintmax_t{1} << 30);
  expect_rejected({
      {2, "run majorty in.png out.png", {"'majorty'; did you mean 'majority'?"}},
      {2, "run wxyz in.png out.png", {"'wxyz'; known: midpoint_scan, thin_naccache_shinghal, "}},
      {2, "run B9/S23 in.png out.png", {"'B9/S23', column 2", "digit from 0 to 8, got '9'"}},
      {2, "run B3/S2x in.png out.png", {"rule 'B3/S2x', column 6: "}},
      {2, "run B3/S23 in.png out.png", {"B3/S23" + limit}},
      {2, "run life.json in.png out.png", {"life" + limit}},
      {2, "graph in.png --thinning B3/S23", {"B3/S23" + limit}},
      {2, "run thin_mb2 in.png out.png --border foreground", {"expected background or keep"}},
      {1, "run absent.json in.png out.png", {"cannot read 'absent.json': there is no such file"}},
      {1, "run huge.json in.png out.png", {"it has more than 1,000,000 bytes"}},
      {1, "run wrong.json in.png out.png", {"wrong.json: hensel is invalid", "column 5"}},
  });
}

TEST_F(Rules, rule_describes_rules_of_every_kind_in_one_line) {
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

TEST_F(Rules, rule_saves_a_rule_that_reads_back) {
  const std::string described =
      output_of("rule golay_l --save saved.json --border keep --max-iterations 4");
  EXPECT_TRUE(described.ends_with(", border keep, limit 4\n"));
  const RuleDescription saved = read_rule_file("saved.json");
  EXPECT_EQ(saved.name, "golay_l");
  EXPECT_TRUE(std::ranges::equal(saved.sub_iterations, Rule::named("golay_l").sub_iterations()));
  run("saved.json");
  expect_image("out.png", applied(Rule::named("golay_l"), {Border::keep, 4}));
}

TEST_F(Rules, rule_saves_built_in_rules_and_rules_without_a_limit) {
  output_of("rule thin_guo_hall --save saved.json");
  run("saved.json");
  expect_image("out.png", applied(Rule::guo_hall));
  output_of("rule B3/S23 --save saved.json");
  EXPECT_EQ(read_rule_file("saved.json").max_iterations, kUnlimited);
}

TEST_F(Rules, rule_lists_the_named_rules) {
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

TEST_F(Rules, rule_rejects_rules_without_tables_and_wrong_words) {
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
