// What all commands have in common.
#include <gtest/gtest.h>

#include "cli/names.hpp"
#include "support/isa_tests.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/rule.hpp"
#include "typed.hpp"

namespace thinbench {
namespace {

using Program = Commands;

TEST_F(Program, without_arguments_prints_the_help_to_standard_error) {
  const ProgramRun run = typed("");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  expect_holds(run.err, "Usage: thinbench");
}

TEST_F(Program, every_help_has_examples) {
  expect_every_help_has_examples(1 + 13);
}

TEST_F(Program, version_is_one_line) {
  const std::string version = output_of("--version");
  expect_begins(version, "thinbench ");
  EXPECT_EQ(version.find('\n') + 1, version.size());
}

TEST_F(Program, list_has_a_line_for_each_operation) {
  const std::string out = output_of("list");
  for (const RuleInfo& rule : kRules) {
    expect_holds(out, "\n" + std::string(rule.operation) + " ");
    expect_holds(out, std::string(rule.description));
  }
  for (const EdgeOperatorInfo& op : kEdgeOperators) {
    expect_holds(out, "\n" + std::string(op.operation) + " ");
  }
  expect_holds(out, "\nholes ");
}

TEST_F(Program, fails_if_standard_output_cannot_be_written) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(run_program(thinbench_program(), {"list"}, out, err), 1);
  EXPECT_EQ(err.str(), "thinbench: standard output cannot be written\n");
}

TEST_F(Program, rejects_unknown_words_with_the_nearest_and_missing_and_excess_ones) {
  const std::string run = "run thin_guo_hall in.png out.png";
  const std::string see = "; see 'thinbench run --help'";
  expect_rejected({
      {2, "lst", {"no command is named 'lst'; did you mean 'list'?"}},
      {2,
       "frobnicate",
       {"'frobnicate'; known: list, run, rule, batch, edges, holes, localise, fill-holes, labels, "
        "distance, euler, graph and path"}},
      {2, run + " --treshold 5", {"'--treshold'; did you mean '--threshold'? See 'thinbench run"}},
      {2, "--bogus", {"there is no option '--bogus'; see 'thinbench --help'"}},
      {2, "--json list", {"there is no option '--json'"}},
      {2, "run", {"RULE is required" + see}},
      {2, "run thin_guo_hall in.png", {"OUT is required" + see}},
      {2, run + " --threshold", {"--threshold needs a value" + see}},
      {2, run + " more.png", {"'more.png' was not expected" + see}},
      {2, run + " --isa avx2 --isa avx2", {"--isa may be given only once" + see}},
      {2,
       "run list holes run",
       {"no operation is named 'list'; known: midpoint_scan, thin_naccache_shinghal, "}},
  });
}

TEST_F(Program, rejects_values_with_what_was_given_and_expected) {
  const std::string run = "run thin_guo_hall in.png out.png ";
  const std::string threads = "--threads: expected an integer in [1, 1024], got ";
  const std::string iterations = "--max-iterations: expected an integer in [1, 2147483647], got ";
  expect_rejected({
      {2, run + "--threads 0", {threads + "'0'; see 'thinbench run"}},
      {2, run + "--threads=1025", {threads + "'1025'"}},
      {2, run + "--threads two", {threads + "'two'"}},
      {2, run + "--threads 1.5", {threads + "'1.5'"}},
      {2, run + "--threads 0x10", {threads + "'0x10'"}},
      {2, run + "--threads ''", {threads + "''"}},
      {2, run + "--max-iterations 2147483648", {iterations + "'2147483648'"}},
      {2, run + "--isa ''", {"--isa: expected a value, got ''"}},
      {2, run + "--weights ''", {"--weights: expected a value, got ''"}},
  });
}

/// Commands that read images, with their required arguments.
const char* const kImageCommands[] = {"run thin_guo_hall absent.png out.png ",
                                      "edges absent.png out.png ", "holes absent.png "};

TEST_F(Program, every_command_that_reads_images_has_the_same_options) {
  for (const std::string command : kImageCommands) {
    for (const char* options :
         {"--foreground auto --threshold otsu", "--foreground bright",
          "--foreground dark --threshold 255", "--threshold 0", "--threshold local"}) {
      expect_rejected({1, command + options, {"cannot read 'absent.png': there is no such file"}});
    }
    const std::string levels = "--threshold: expected a number, 'otsu' or 'local'";
    expect_rejected({
        {2, command + "--foreground black", {"expected auto, bright or dark, got 'black'"}},
        {2, command + "--foreground ''", {"expected auto, bright or dark, got ''"}},
        {2, command + "--threshold high", {levels + ", got 'high'"}},
        {2, command + "--threshold nan", {levels + ", got 'nan'"}},
        {2, command + "--invert x", {"there is no option '--invert'"}},
    });
  }
}

TEST_F(Program, every_command_rejects_a_malformed_cap) {
  const IsaCap cap("sse9");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  const std::string text = "THINBENCH_MAX_ISA: expected one of " + all_isa_names() + ", got 'sse9'";
  for (const std::string command :
       {"list", "run thin_guo_hall in.png out.png", "rule", "batch thin_guo_hall in --out out",
        "graph in.png", "holes in.png", "edges in.png out.png"}) {
    expect_rejected({2, command, {text}});
  }
  EXPECT_EQ(typed("--help").status, 0);
}

TEST_F(Program, isas_that_are_not_available_are_rejected_with_the_reason) {
  write_grey("in.png", ByteImage(9, 9).view());
  const IsaCap cap("baseline");
  if (!cap.is_in_force()) GTEST_SKIP() << kCapWasRead;
  for (const Isa isa : all_isas()) {
    if (isa == Isa::baseline) continue;
    const std::string reason = cpu_supports(isa) ? "above the ISA cap" : "this machine lacks ";
    for (const std::string command : {"run thin_guo_hall in.png out.png", "holes in.png"}) {
      expect_rejected({1, command + " --isa " + std::string(isa_name(isa)), {reason}});
    }
  }
}

const std::vector<std::string_view> kKnown = {"baseline", "sse4.2", "avx2", "avx512", "avx512icl"};

TEST(NearestName, tolerates_typing_errors_and_capitals) {
  EXPECT_EQ(nearest_name("sse42", kKnown), "sse4.2");
  EXPECT_EQ(nearest_name("AVX2", kKnown), "avx2");
  EXPECT_EQ(nearest_name("avx512vl", kKnown), "avx512");
  EXPECT_EQ(nearest_name("bsaeline", kKnown), "baseline");
}

TEST(NearestName, completes_a_prefix) {
  EXPECT_EQ(nearest_name("base", kKnown), "baseline");
  EXPECT_EQ(nearest_name("avx", kKnown), "avx2");
}

TEST(NearestName, is_empty_for_a_different_word) {
  EXPECT_EQ(nearest_name("neon", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("", kKnown), std::nullopt);
  EXPECT_EQ(nearest_name("avx2", {}), std::nullopt);
}

TEST(Enumeration, joins_words_with_commas_and_and) {
  EXPECT_EQ(enumeration({}), "");
  EXPECT_EQ(enumeration({"a"}), "a");
  EXPECT_EQ(enumeration({"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace thinbench
