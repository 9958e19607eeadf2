// thinbench run with rules of every kind: names, notations and files.
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "noise_fixture.hpp"
#include "support/packed_image.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

class RunRules : public NoiseFixture {
 protected:
  [[nodiscard]] std::string failure(const std::string& rule, int status,
                                    const std::vector<std::string>& more = {}) const {
    std::string text = failure_of(words(rule, more), status);
    EXPECT_FALSE(std::filesystem::exists(out));
    return text;
  }
};

TEST_F(RunRules, named_rule_is_applied_and_prints_one_line) {
  const ProgramRun result = run("majority");
  const std::regex line(R"(majority: 203 x 70, 1 iteration, \d+ foreground pixels before, )"
                        R"(\d+ after, \d+\.\d{3} ms\n)");
  EXPECT_TRUE(std::regex_match(result.out, line)) << result.out;
  EXPECT_TRUE(wrote(applied(Rule::named("majority"))));
  EXPECT_EQ(directory.names(), (Names{"in.png", "out.png"}));
}

TEST_F(RunRules, built_in_rule_has_the_name_of_its_operation) {
  EXPECT_EQ(run("guo_hall").out.rfind("thin_guo_hall: ", 0), 0U);
  EXPECT_TRUE(wrote(applied(Rule::guo_hall)));
}

TEST_F(RunRules, notation_is_applied) {
  const std::string text = run("B3/S23", {"--max-iterations", "5"}).out;
  EXPECT_EQ(text.rfind("B3/S23: ", 0), 0U) << text;
  EXPECT_TRUE(wrote(applied(Rule(table_from_hensel("B3/S23")), {.max_iterations = 5})));
  run("b2-as12", {"--max-iterations", "1"});
  EXPECT_TRUE(wrote(applied(Rule(table_from_hensel("B2-a/S12")), {.max_iterations = 1})));
}

TEST_F(RunRules, file_is_applied_with_its_border_and_limit) {
  const std::string file = directory.with(
      "two.json",
      R"({"name": "twice", "hensel": "B3/S23", "max_iterations": 2, "border": "keep"})");
  const std::string text = run(file).out;
  EXPECT_EQ(text.rfind("twice: ", 0), 0U) << text;
  EXPECT_TRUE(wrote(applied(Rule(table_from_hensel("B3/S23")), {Border::keep, 2})));
}

TEST_F(RunRules, options_override_border_and_limit) {
  const std::string file =
      directory.with("two.json", R"({"hensel": "B3/S23", "max_iterations": 2, "border": "keep"})");
  run(file, {"--border", "foreground", "--max-iterations", "3"});
  EXPECT_TRUE(wrote(applied(Rule(table_from_hensel("B3/S23")), {Border::foreground, 3})));
}

TEST_F(RunRules, every_border_applies_to_built_in_rules_and_nets) {
  for (const char* const name : {"thin_zhang_suen", "net_two_layer_linear"}) {
    for (const Border border : {Border::background, Border::keep, Border::foreground}) {
      run(name, {"--border", std::string(border_name(border))});
      EXPECT_TRUE(wrote(applied(Rule::named(name), {.border = border}))) << name;
    }
  }
}

TEST_F(RunRules, border_of_foreground_is_rejected_for_rules_without_tables) {
  EXPECT_EQ(
      failure("thin_mb2", 1, {"--border", "foreground"}),
      "thin_mb2: border: expected background or keep, got foreground, which only rules that are "
      "functions of 3 x 3 pixels can have");
}

TEST_F(RunRules, file_needs_no_extension) {
  const std::string file = directory.with("plain", R"({"hensel": "B/S", "max_iterations": 1})");
  EXPECT_EQ(run(file).out.rfind("plain: ", 0), 0U);
}

TEST_F(RunRules, isa_and_threads_do_not_change_the_pixels) {
  run("bridge", {"--isa", "baseline", "--threads", "2"});
  EXPECT_TRUE(wrote(applied(Rule::named("bridge"))));
}

TEST_F(RunRules, optimise_gives_the_same_pixels) {
  run("erode", {"--optimise"});
  EXPECT_TRUE(wrote(applied(Rule::named("erode"))));
}

TEST_F(RunRules, packed_files_take_every_rule) {
  const std::string header = "P4 203 70\n";
  const auto packed = [&](const ByteImage& image) {
    return header + raw_bytes(PackedImage(image.view(), BitOrder::msb_first));
  };
  const std::string pbm = directory.with("in.pbm", packed(noise()));
  const std::string result = directory.file("out.pbm");
  ASSERT_EQ(run_with({"run", "majority", pbm, result}).status, 0);
  EXPECT_EQ(bytes_of(result), packed(applied(Rule::named("majority"))));
  ASSERT_EQ(run_with({"run", "golay_l", pbm, result, "--out-of-core"}).status, 0);
  EXPECT_EQ(bytes_of(result), packed(applied(Rule::named("golay_l"))));
  EXPECT_EQ(failure_of({"run", "majority", pbm, result, "--threshold", "5"}, 2),
            "--threshold does not apply to packed files, whose pixels have one bit");
}

TEST_F(RunRules, unknown_names_are_rejected) {
  EXPECT_EQ(failure("majorty", 2), "no rule is named 'majorty'; did you mean 'majority'?");
  EXPECT_EQ(failure("bridg", 2), "no rule is named 'bridg'; did you mean 'bridge'?");
  EXPECT_EQ(failure("wxyz", 2).rfind("no rule is named 'wxyz'; known: thin_naccache_shinghal, ", 0),
            0U);
  EXPECT_EQ(failure("majority", 2, {"--border", "keeep"}),
            "no border is named 'keeep'; did you mean 'keep'?");
}

TEST_F(RunRules, malformed_notations_are_rejected_with_the_column) {
  EXPECT_EQ(failure("B9/S23", 2), "rule 'B9/S23', column 2: expected a digit from 0 to 8, got '9'");
  EXPECT_EQ(failure("B3/S2x", 2).rfind("rule 'B3/S2x', column 6: ", 0), 0U);
}

TEST_F(RunRules, rules_that_may_never_end_need_a_limit) {
  const std::string why =
      ": this rule adds and removes pixels, so it may never end; it needs max_iterations";
  EXPECT_EQ(failure("B3/S23", 1), "B3/S23" + why);
  EXPECT_EQ(failure(directory.with("life.json", R"({"hensel": "B3/S23"})"), 1), "life" + why);
}

TEST_F(RunRules, files_that_cannot_be_read_are_rejected) {
  EXPECT_EQ(failure("absent.json", 1), "cannot read 'absent.json': there is no such file");
  EXPECT_EQ(failure("/absent/rule", 1), "cannot read '/absent/rule': there is no such file");
  const std::string huge = directory.with("huge.json", "{");
  std::filesystem::resize_file(huge, std::uintmax_t{1} << 30);
  EXPECT_EQ(failure(huge, 1), "cannot read '" + huge + "': it has more than 1,000,000 bytes");
  const std::string fifo = directory.file("fifo");
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_EQ(failure(fifo, 1), "cannot read '" + fifo + "': it is not a regular file");
  const std::string folder = directory.path().string();
  EXPECT_EQ(failure(folder, 1), "cannot read '" + folder + "': it is a directory");
}

TEST_F(RunRules, files_that_are_no_rules_are_rejected_with_the_field) {
  const auto error = [&](const std::string& text) {
    const std::string file = directory.with("bad.json", text);
    return failure(file, 1).substr(file.size());
  };
  EXPECT_EQ(error(R"({"hensel": "B/S", "hensel": "B3/S23"})"), ": the key \"hensel\" is repeated");
  EXPECT_EQ(error("[1, 2"), ": not JSON, or truncated, at byte 6 of 5");
  EXPECT_EQ(error(R"({"sub_iterations": [{"raster": "01"}]})"),
            ": sub_iterations[0].raster has 2 characters; it must have 512 digits 0 and 1 or 128 "
            "hexadecimal digits");
  EXPECT_EQ(error(R"({"hensel": "B3/S9"})"),
            ": hensel is invalid: rule 'B3/S9', column 5: expected a digit from 0 to 8, got '9'");
}

}  // namespace
}  // namespace thinbench
