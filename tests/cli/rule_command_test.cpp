// thinbench rule: named rules, notations and files; what it prints, writes and rejects.
#include <filesystem>
#include <regex>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "harness/test_images.hpp"
#include "images/image_file.hpp"
#include "program_run.hpp"
#include "rules/rule_file.hpp"
#include "support/packed_image.hpp"
#include "support/temporary_directory.hpp"
#include "thinbench/named_rules.hpp"
#include "thinbench/rule_notation.hpp"

namespace thinbench {
namespace {

using Names = std::set<std::string>;

constexpr Index kWidth = 203;
constexpr Index kHeight = 70;

ByteImage noise() {
  ByteImage image = noise_image(kWidth, kHeight, 50, 4, 7);
  for (Index y = 0; y < kHeight; ++y) {
    for (Index x = 0; x < kWidth; ++x) image.at(x, y) = image.at(x, y) != 0 ? 255 : 0;
  }
  return image;
}

ByteImage applied(const CustomRule& rule) {
  const ByteImage image = noise();
  ByteImage result(kWidth, kHeight);
  apply(rule, image.view(), result.view());
  return result;
}

ByteImage applied(const char* name) {
  const NamedRule& rule = *find_named_rule(name);
  return applied(CustomRule(rule.sub_iterations, rule.options()));
}

class RuleCommand : public testing::Test {
 protected:
  void SetUp() override { write_grey(in, noise().view()); }

  /// Foreground is bright, so that nothing is remarked.
  [[nodiscard]] std::vector<std::string> words(const std::string& rule,
                                               std::vector<std::string> more) const {
    more.insert(more.begin(), {"rule", rule, in, out, "--foreground", "bright"});
    return more;
  }
  ProgramRun run(const std::string& rule, const std::vector<std::string>& more = {}) const {
    ProgramRun result = run_with(words(rule, more));
    EXPECT_EQ(result.status, 0) << result.err;
    return result;
  }
  [[nodiscard]] std::string failure(const std::string& rule, int status,
                                    const std::vector<std::string>& more = {}) const {
    std::string text = failure_of(words(rule, more), status);
    EXPECT_FALSE(std::filesystem::exists(out));
    return text;
  }
  [[nodiscard]] bool wrote(const ByteImage& expected) const {
    return equal(read_grey(out).view(), expected.view());
  }

  TemporaryDirectory directory;
  std::string in = directory.file("in.png");
  std::string out = directory.file("out.png");
};

TEST_F(RuleCommand, applies_a_named_rule_and_prints_one_line) {
  const ProgramRun result = run("majority");
  const std::regex line(R"(majority: 203 x 70, 1 iteration, \d+ foreground pixels before, )"
                        R"(\d+ after, \d+\.\d{3} ms, gates: \d+\n)");
  EXPECT_TRUE(std::regex_match(result.out, line)) << result.out;
  EXPECT_TRUE(wrote(applied("majority")));
  EXPECT_EQ(directory.names(), (Names{"in.png", "out.png"}));
}

TEST_F(RuleCommand, prints_the_gates_of_every_sub_iteration) {
  const NamedRule& thin = *find_named_rule("thin");
  const CustomRule rule(thin.sub_iterations, thin.options());
  const std::string expected =
      ", gates: " + std::to_string(rule.gates(0)) + " + " + std::to_string(rule.gates(1)) + "\n";
  const std::string text = run("thin").out;
  EXPECT_TRUE(text.ends_with(expected)) << text;
}

TEST_F(RuleCommand, applies_a_notation) {
  const std::string text = run("B3/S23", {"--max-iterations", "5"}).out;
  EXPECT_EQ(text.rfind("B3/S23: ", 0), 0U) << text;
  EXPECT_TRUE(wrote(applied(CustomRule(table_from_hensel("B3/S23"), {.max_iterations = 5}))));
  run("b2-as12", {"--max-iterations", "1"});
  EXPECT_TRUE(wrote(applied(CustomRule(table_from_hensel("B2-a/S12"), {.max_iterations = 1}))));
}

TEST_F(RuleCommand, applies_a_file_with_its_border_and_limit) {
  const std::string file = directory.with(
      "two.json",
      R"({"name": "twice", "hensel": "B3/S23", "max_iterations": 2, "border": "keep"})");
  const std::string text = run(file).out;
  EXPECT_EQ(text.rfind("twice: ", 0), 0U) << text;
  EXPECT_TRUE(wrote(applied(
      CustomRule(table_from_hensel("B3/S23"), {.border = Border::keep, .max_iterations = 2}))));
}

TEST_F(RuleCommand, options_override_border_and_limit) {
  const std::string file =
      directory.with("two.json", R"({"hensel": "B3/S23", "max_iterations": 2, "border": "keep"})");
  run(file, {"--border", "foreground", "--max-iterations", "3"});
  EXPECT_TRUE(wrote(applied(CustomRule(table_from_hensel("B3/S23"),
                                       {.border = Border::foreground, .max_iterations = 3}))));
}

TEST_F(RuleCommand, a_file_needs_no_extension) {
  const std::string file = directory.with("plain", R"({"hensel": "B/S", "max_iterations": 1})");
  EXPECT_EQ(run(file).out.rfind("plain: ", 0), 0U);
}

TEST_F(RuleCommand, isa_and_threads_do_not_change_the_pixels) {
  EXPECT_EQ(run("bridge", {"--isa", "baseline", "--threads", "2"}).status, 0);
  EXPECT_TRUE(wrote(applied("bridge")));
}

TEST_F(RuleCommand, optimise_gives_the_same_pixels) {
  run("erode", {"--optimise"});
  EXPECT_TRUE(wrote(applied("erode")));
}

TEST_F(RuleCommand, applies_rules_to_packed_files) {
  const ByteImage image = noise();
  const std::string pbm = directory.with(
      "in.pbm", "P4 203 70\n" + raw_bytes(PackedImage(image.view(), BitOrder::msb_first)));
  const std::string result = directory.file("out.pbm");
  ASSERT_EQ(run_with({"rule", "majority", pbm, result}).status, 0);
  EXPECT_EQ(bytes_of(result), "P4 203 70\n" + raw_bytes(PackedImage(applied("majority").view(),
                                                                    BitOrder::msb_first)));
  EXPECT_EQ(failure_of({"rule", "majority", pbm, result, "--threshold", "5"}, 2),
            "--threshold does not apply to packed files, whose foreground is 1");
}

TEST_F(RuleCommand, saves_a_rule_that_reads_back) {
  const std::string file = directory.file("saved.json");
  const std::vector<std::string> more = {"--border", "keep", "--max-iterations", "4"};
  std::vector<std::string> save = {"rule", "golay_l", "--save", file};
  save.insert(save.end(), more.begin(), more.end());
  EXPECT_EQ(run_with(save).out, file + ": golay_l, 8 sub-iterations\n");
  const RuleDescription saved = read_rule_file(file);
  const NamedRule& golay = *find_named_rule("golay_l");
  EXPECT_EQ(saved.name, "golay_l");
  EXPECT_TRUE(std::ranges::equal(saved.sub_iterations, golay.sub_iterations));
  EXPECT_EQ(saved.border, Border::keep);
  EXPECT_EQ(saved.max_iterations, 4);
  run("golay_l", more);
  const ByteImage direct = read_grey(out);
  run(file);
  EXPECT_TRUE(wrote(direct));
}

TEST_F(RuleCommand, saves_and_applies_at_once) {
  const std::string file = directory.file("saved.json");
  const std::string text = run("clean", {"--save", file}).out;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_EQ(read_rule_file(file).max_iterations, 1);
  EXPECT_TRUE(wrote(applied("clean")));
}

TEST_F(RuleCommand, lists_the_named_rules) {
  const ProgramRun listed = run_with({"rule", "--list"});
  EXPECT_EQ(listed.status, 0) << listed.err;
  std::istringstream lines(listed.out);
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

TEST_F(RuleCommand, incomplete_command_lines_are_rejected) {
  EXPECT_EQ(failure_of({"rule"}, 2), "rule needs RULE, or --list");
  EXPECT_EQ(failure_of({"rule", "majority"}, 2), "rule needs IN and OUT, or --save");
  EXPECT_EQ(failure_of({"rule", "majority", in}, 2), "rule needs OUT, an image to write");
  EXPECT_EQ(failure_of({"rule", "majority", in, "--save", directory.file("a.json")}, 2),
            "rule needs OUT, an image to write");
  EXPECT_EQ(failure_of({"rule", "majority", "--list"}, 2), "--list takes no RULE");
  EXPECT_EQ(directory.names(), Names{"in.png"});
}

TEST_F(RuleCommand, unknown_names_are_rejected) {
  EXPECT_EQ(failure("majorty", 2), "no rule is named 'majorty'; did you mean 'majority'?");
  EXPECT_EQ(failure("bridg", 2), "no rule is named 'bridg'; did you mean 'bridge'?");
  EXPECT_EQ(failure("wxyz", 2).rfind("no rule is named 'wxyz'; known: bridge, clean, ", 0), 0U);
  EXPECT_EQ(failure("majority", 2, {"--border", "keeep"}),
            "no border is named 'keeep'; did you mean 'keep'?");
}

TEST_F(RuleCommand, malformed_notations_are_rejected_with_the_column) {
  EXPECT_EQ(failure("B9/S23", 2), "rule 'B9/S23', column 2: expected a digit from 0 to 8, got '9'");
  EXPECT_EQ(failure("B3/S2x", 2).rfind("rule 'B3/S2x', column 6: ", 0), 0U);
}

TEST_F(RuleCommand, rules_that_may_never_end_need_a_limit) {
  const std::string why =
      ": this rule adds and removes pixels, so it may never end; it needs max_iterations, such as "
      "--max-iterations 100";
  EXPECT_EQ(failure("B3/S23", 2), "B3/S23" + why);
  const std::string file = directory.with("life.json", R"({"hensel": "B3/S23"})");
  EXPECT_EQ(failure(file, 2), file + why);
  EXPECT_EQ(failure_of({"rule", "B3/S23", "--save", directory.file("a.json")}, 2), "B3/S23" + why);
}

TEST_F(RuleCommand, files_that_cannot_be_read_are_rejected) {
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

TEST_F(RuleCommand, files_that_are_no_rules_are_rejected_with_the_field) {
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

TEST_F(RuleCommand, unreadable_images_and_unwritable_targets_are_rejected) {
  EXPECT_EQ(failure_of({"rule", "majority", directory.file("absent.png"), out}, 1),
            "cannot read '" + directory.file("absent.png") + "': there is no such file");
  EXPECT_EQ(failure_of({"rule", "majority", in, directory.file("a.gif")}, 2)
                    .find("unknown extension '.gif'") != std::string::npos,
            true);
  EXPECT_EQ(failure_of({"rule", "majority", "--save", "/absent/rule.json"}, 1),
            "cannot write '/absent/rule.json': there is no directory '/absent'");
}

}  // namespace
}  // namespace thinbench
