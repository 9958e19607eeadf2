#include <gtest/gtest.h>

#include "program_run.hpp"
#include "support/command_help.hpp"
#include "support/isa_parameters.hpp"
#include "thinbench/edges.hpp"
#include "thinbench/rule.hpp"

namespace thinbench {
namespace {

constexpr const char* kOperation = "thin_naccache_shinghal";

/// The error message of `run OPERATION in.png out.png` with more arguments.
std::string run_failure(std::vector<std::string> more) {
  more.insert(more.begin(), {"run", kOperation, "in.png", "out.png"});
  return failure_of(more, 2);
}

TEST(Program, without_arguments_prints_the_help_to_standard_error) {
  const ProgramRun run = run_with({});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("Usage: thinbench"), std::string::npos);
}

TEST(Program, every_help_has_examples) {
  EXPECT_EQ(all_commands(thinbench_program()).size(), 1 + 13U);
  expect_every_help_has_examples(thinbench_program());
}

TEST(Program, version_is_one_line) {
  const ProgramRun run = run_with({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.rfind("thinbench ", 0), 0U);
  EXPECT_EQ(run.out.find('\n') + 1, run.out.size());
}

TEST(Program, unknown_command_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure_of({"lst"}, 2), "no command is named 'lst'; did you mean 'list'?");
  EXPECT_EQ(
      failure_of({"frobnicate"}, 2),
      "no command is named 'frobnicate'; known: list, run, rule, batch, edges, holes, localise, "
      "fill-holes, labels, distance, euler, graph and path");
}

TEST(Program, unknown_option_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(run_failure({"--treshold", "5"}),
            "there is no option '--treshold'; did you mean '--threshold'? "
            "See 'thinbench run --help'");
  EXPECT_EQ(failure_of({"--bogus"}, 2), "there is no option '--bogus'; see 'thinbench --help'");
  EXPECT_EQ(failure_of({"--json", "list"}, 2),
            "there is no option '--json'; see 'thinbench --help'");
}

TEST(Program, missing_arguments_are_rejected) {
  EXPECT_EQ(failure_of({"run"}, 2), "RULE is required; see 'thinbench run --help'");
  EXPECT_EQ(failure_of({"run", kOperation, "in.png"}, 2),
            "OUT is required; see 'thinbench run --help'");
  EXPECT_EQ(run_failure({"--threshold"}), "--threshold needs a value; see 'thinbench run --help'");
}

TEST(Program, excess_arguments_are_rejected) {
  EXPECT_EQ(run_failure({"more.png"}), "'more.png' was not expected; see 'thinbench run --help'");
  EXPECT_EQ(run_failure({"--isa", "avx2", "--isa", "avx2"}),
            "--isa may be given only once; see 'thinbench run --help'");
}

TEST(Program, names_of_commands_are_valid_arguments) {
  const std::string text = failure_of({"run", "list", "holes", "run"}, 2);
  EXPECT_EQ(text.find("no rule is named 'list'; known: "), 0U) << text;
}

TEST(Program, empty_values_are_rejected) {
  for (const std::string option : {"--isa", "--weights"}) {
    const std::string text = option + ": expected a value, got ''; see 'thinbench run --help'";
    EXPECT_EQ(run_failure({option, ""}), text);
    EXPECT_EQ(run_failure({option + "="}), option + " needs a value; see 'thinbench run --help'");
  }
}

TEST(Program, numbers_out_of_range_are_rejected_with_the_range) {
  const std::string see = "; see 'thinbench run --help'";
  for (const std::string value : {"256", "-1", "x", "1.5", "0x10", ""}) {
    EXPECT_EQ(run_failure({"--threshold=" + value}).find("--threshold"), 0U);
    EXPECT_EQ(run_failure({"--threshold", value}),
              "--threshold: expected an integer in [0, 255] or 'otsu' or 'local', got '" + value +
                  "'" + see);
  }
  for (const std::string value : {"0", "1025", "two"}) {
    EXPECT_EQ(run_failure({"--threads", value}),
              "--threads: expected an integer in [1, 1024], got '" + value + "'" + see);
  }
  for (const std::string value : {"0", "-1", "2147483648", "many"}) {
    EXPECT_EQ(
        run_failure({"--max-iterations", value}),
        "--max-iterations: expected an integer in [1, 2147483647], got '" + value + "'" + see);
  }
}

/// All commands that read images, with their required arguments.
std::vector<Words> image_commands() {
  return {{"run", kOperation, "absent.png", "out.png"},
          {"edges", "absent.png", "out.png"},
          {"holes", "absent.png"}};
}

TEST(Program, every_command_that_reads_images_accepts_the_same_options) {
  for (const Words& command : image_commands()) {
    for (const Words& options :
         {Words{"--foreground", "auto", "--threshold", "otsu"}, Words{"--foreground", "bright"},
          Words{"--foreground", "dark", "--threshold", "255"}, Words{"--threshold", "0"}}) {
      Words words = command;
      words.insert(words.end(), options.begin(), options.end());
      EXPECT_EQ(failure_of(words, 1), "cannot read 'absent.png': there is no such file");
    }
  }
}

TEST(Program, every_command_that_reads_images_rejects_the_same_values) {
  for (const Words& command : image_commands()) {
    const auto failure = [&](const std::string& option, const std::string& value) {
      Words words = command;
      words.insert(words.end(), {option, value});
      const std::string text = failure_of(words, 2);
      return text.substr(0, text.find("; see '"));
    };
    EXPECT_EQ(failure("--foreground", "black"),
              "--foreground: expected auto, bright or dark, got 'black'");
    EXPECT_EQ(failure("--foreground", ""), "--foreground: expected auto, bright or dark, got ''");
    EXPECT_EQ(failure("--threshold", "high"),
              "--threshold: expected an integer in [0, 255] or 'otsu' or 'local', got 'high'");
    EXPECT_EQ(failure("--threshold", "256"),
              "--threshold: expected an integer in [0, 255] or 'otsu' or 'local', got '256'");
    EXPECT_EQ(failure("--invert", "x"), "there is no option '--invert'") << command.front();
  }
}

TEST(Program, every_command_rejects_a_malformed_cap) {
  const IsaCap cap("sse9");
  const std::string text = "THINBENCH_MAX_ISA: expected one of " + all_isa_names() + ", got 'sse9'";
  const std::string name = kOperation;
  for (const Words& words : {Words{"list"}, Words{"run", name, "in.png", "out.png"}, Words{"rule"},
                             Words{"batch", name, "in", "--out", testing::TempDir() + "out"},
                             Words{"graph", "in.png"},
                             Words{"holes", "in.png"}, Words{"edges", "in.png", "out.png"}}) {
    EXPECT_EQ(failure_of(words, 2), text) << words.front();
  }
  EXPECT_EQ(run_with({"--help"}).status, 0);
}

TEST(ListCommand, prints_a_line_for_each_operation) {
  const std::string out = run_with({"list"}).out;
  for (const RuleInfo& rule : kRules) {
    EXPECT_NE(out.find("\n" + std::string(rule.operation) + " "), std::string::npos) << out;
    EXPECT_NE(out.find(rule.description), std::string::npos) << out;
  }
  for (const EdgeOperatorInfo& op : kEdgeOperators) {
    EXPECT_NE(out.find("\n" + std::string(op.operation) + " "), std::string::npos) << out;
  }
  EXPECT_NE(out.find("\nholes "), std::string::npos) << out;
}

TEST(Program, fails_if_standard_output_cannot_be_written) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(run_program(thinbench_program(), {"list"}, out, err), 1);
  EXPECT_EQ(err.str(), "thinbench: standard output cannot be written\n");
}

}  // namespace
}  // namespace thinbench
