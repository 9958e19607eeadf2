// thinbench run with rules of every kind: names, notations and files.
#include <regex>

#include <gtest/gtest.h>

#include "noise_image.hpp"
#include "thinbench/midpoint_scan.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using RunRules = NoiseImage;

const Rule kLife(table_from_hensel("B3/S23"));

TEST_F(RunRules, every_kind_of_rule_is_applied_and_prints_its_name) {
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

TEST_F(RunRules, the_scan_has_the_border_background_or_keep) {
  for (const Border border : {Border::background, Border::keep}) {
    ByteImage expected = noise();
    midpoint_scan(expected.view(), expected.view(), {}, border);
    run("skeleton_scan --border " + std::string(border_name(border)));
    expect_image("out.png", expected);
  }
  expect_rejected({2,
                   "run skeleton_scan --border foreground in.png no.png",
                   {"skeleton_scan: border: expected background or keep, got foreground"}});
}

TEST_F(RunRules, names_notations_and_files_that_are_no_rules_are_rejected) {
  const std::string limit =
      ": this rule adds and removes pixels, so it may never end; it needs a limit";
  put("life.json", R"({"hensel": "B3/S23"})");
  put("wrong.json", R"({"hensel": "B3/S9"})");
  put("huge.json", "{");
  fs::resize_file("huge.json", std::uintmax_t{1} << 30);
  expect_rejected({
      {2, "run majorty in.png out.png", {"'majorty'; did you mean 'majority'?"}},
      {2, "run wxyz in.png out.png", {"'wxyz'; known: skeleton_scan, thin_naccache_shinghal, "}},
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

}  // namespace
}  // namespace thinbench
