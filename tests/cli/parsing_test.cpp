#include <gtest/gtest.h>

#include "program_run.hpp"

namespace thinbench {
namespace {

constexpr const char* kOperation = "thin_naccache_shinghal";

/// The failure of `run OPERATION in.png out.png` with these arguments more.
std::string run_failure(std::vector<std::string> more) {
  more.insert(more.begin(), {"run", kOperation, "in.png", "out.png"});
  return failure_of(more, 2);
}

TEST(Program, no_arguments_print_the_help_as_an_error) {
  const ProgramRun run = run_with({});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("Usage: thinbench"), std::string::npos);
}

TEST(Program, every_help_has_examples) {
  for (const std::string command : {"", "list", "verify", "run", "scene", "machine"}) {
    const ProgramRun run = command.empty() ? run_with({"--help"}) : run_with({command, "--help"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Usage: thinbench " + command), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("Examples:\n  thinbench " + command), std::string::npos) << run.out;
  }
}

TEST(Program, version_is_one_line) {
  const ProgramRun run = run_with({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.rfind("thinbench ", 0), 0U);
  EXPECT_EQ(run.out.find('\n') + 1, run.out.size());
}

TEST(Program, unknown_command_gets_the_nearest_known_name) {
  EXPECT_EQ(failure_of({"lst"}, 2), "no command is named 'lst'; did you mean 'list'?");
  EXPECT_EQ(failure_of({"frobnicate"}, 2),
            "no command is named 'frobnicate'; known: list, verify, run, scene, machine, train and "
            "experiment");
}

TEST(Program, unknown_option_gets_the_nearest_known_name) {
  EXPECT_EQ(run_failure({"--treshold", "5"}),
            "there is no option '--treshold'; did you mean '--threshold'? "
            "See 'thinbench run --help'");
  EXPECT_EQ(failure_of({"--bogus"}, 2), "there is no option '--bogus'; see 'thinbench --help'");
  EXPECT_EQ(failure_of({"--json", "list"}, 2),
            "there is no option '--json'; see 'thinbench --help'");
}

TEST(Program, missing_arguments_are_named) {
  EXPECT_EQ(failure_of({"run"}, 2), "OPERATION is required; see 'thinbench run --help'");
  EXPECT_EQ(failure_of({"run", kOperation, "in.png"}, 2),
            "OUT is required; see 'thinbench run --help'");
  EXPECT_EQ(run_failure({"--threshold"}), "--threshold needs a value; see 'thinbench run --help'");
}

TEST(Program, too_many_arguments_are_named) {
  EXPECT_EQ(run_failure({"more.png"}),
            "'more.png' is one argument too many; see 'thinbench run --help'");
  EXPECT_EQ(run_failure({"--isa", "avx2", "--isa", "avx2"}),
            "--isa may be given only once; see 'thinbench run --help'");
}

TEST(Program, names_of_commands_may_be_arguments) {
  const std::string text = failure_of({"run", "list", "scene", "run"}, 2);
  EXPECT_EQ(text.find("no operation is named 'list'; known: "), 0U) << text;
}

TEST(Program, numbers_out_of_range_are_refused_with_the_range) {
  const std::string see = "; see 'thinbench run --help'";
  for (const std::string value : {"256", "-1", "x", "1.5", "0x10", ""}) {
    EXPECT_EQ(run_failure({"--threshold=" + value}).find("--threshold"), 0U);
    EXPECT_EQ(run_failure({"--threshold", value}),
              "--threshold: '" + value + "' is no whole number from 0 to 255" + see);
  }
  for (const std::string value : {"0", "1025", "two"}) {
    EXPECT_EQ(run_failure({"--threads", value}),
              "--threads: '" + value + "' is no whole number from 1 to 1024" + see);
  }
}

TEST(Program, malformed_cap_stops_every_command) {
  const IsaCap cap("sse9");
  const std::string text =
      "THINBENCH_MAX_ISA=sse9 is no level; use baseline, sse4.2, avx2, avx512 or avx512icl";
  EXPECT_EQ(failure_of({"list"}, 2), text);
  EXPECT_EQ(failure_of({"verify"}, 2), text);
  EXPECT_EQ(run_failure({}), text);
  EXPECT_EQ(failure_of({"scene", "--truth"}, 2), text);
  EXPECT_EQ(failure_of({"machine"}, 2), text);
  EXPECT_EQ(run_with({"--help"}).status, 0);
}

TEST(Program, output_that_cannot_be_written_is_a_failure) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(run_program({"list"}, out, err), 1);
  EXPECT_EQ(err.str(), "thinbench: standard output cannot be written\n");
}

}  // namespace
}  // namespace thinbench
