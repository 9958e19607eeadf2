#include <gtest/gtest.h>

#include "images/image_file.hpp"
#include "program_run.hpp"
#include "support/isa_parameters.hpp"
#include "support/temporary_directory.hpp"

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

using Words = std::vector<std::string>;

/// The subcommands that the help of a command lists.
Words commands_below(Words words) {
  words.emplace_back("--help");
  std::istringstream help(run_with(words).out);
  Words found;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (listed && line.rfind("  ", 0) == 0 && line[2] != ' ') {
      found.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    listed = (listed && line.rfind("  ", 0) == 0) || line == "Subcommands:";
  }
  return found;
}

/// Every command as a list of words, parents before their subcommands.
std::vector<Words> all_commands() {
  std::vector<Words> commands = {{}};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    for (const std::string& name : commands_below(commands[i])) {
      commands.push_back(commands[i]);
      commands.back().push_back(name);
    }
  }
  return commands;
}

TEST(Program, every_help_has_examples) {
  const std::vector<Words> commands = all_commands();
  EXPECT_EQ(commands.size(), 1 + 14 + 2 + 7U);
  for (Words words : commands) {
    std::string command = "thinbench";
    for (const std::string& word : words) command += " " + word;
    words.emplace_back("--help");
    const ProgramRun run = run_with(words);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Usage: " + command), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("Examples:\n  " + command), std::string::npos) << run.out;
  }
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
      "no command is named 'frobnicate'; known: list, verify, run, rule, batch, edges, holes, "
      "graph, scene, machine, train, experiment, instructions and pictures");
}

TEST(Program, unknown_subcommand_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure_of({"train", "two-layers"}, 2),
            "no command is named 'two-layers'; did you mean 'two-layer'?");
  EXPECT_EQ(failure_of({"experiment", "nothing"}, 2),
            "no command is named 'nothing'; known: edge-quality, literal-holes, cluster-runs, "
            "quantisation, hidden-neurons, quality and operation-counts");
  EXPECT_EQ(failure_of({"train"}, 2),
            "train needs one more word: two-layer or cluster; see 'thinbench train --help'");
}

TEST(Program, unknown_option_of_a_subcommand_is_rejected_with_the_nearest_name) {
  EXPECT_EQ(failure_of({"train", "two-layer", "--sead", "2"}, 2),
            "there is no option '--sead'; did you mean '--seed'? See 'thinbench train two-layer "
            "--help'");
  EXPECT_EQ(failure_of({"experiment", "quantisation", "--quick"}, 2),
            "there is no option '--quick'; see 'thinbench experiment quantisation --help'");
  EXPECT_EQ(failure_of({"train", "--seed", "2", "two-layer"}, 2),
            "there is no option '--seed'; see 'thinbench train --help'");
  EXPECT_EQ(failure_of({"train", "cluster", "more"}, 2),
            "'more' was not expected; see 'thinbench train cluster --help'");
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
  EXPECT_EQ(failure_of({"run"}, 2), "OPERATION is required; see 'thinbench run --help'");
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
  const std::string text = failure_of({"run", "list", "scene", "run"}, 2);
  EXPECT_EQ(text.find("no operation is named 'list'; known: "), 0U) << text;
}

TEST(Program, empty_values_are_rejected) {
  for (const std::string option : {"--technique", "--isa", "--weights"}) {
    const std::string text = option + ": expected a value, got ''; see 'thinbench run --help'";
    EXPECT_EQ(run_failure({option, ""}), text);
    EXPECT_EQ(run_failure({option + "="}), option + " needs a value; see 'thinbench run --help'");
  }
  EXPECT_EQ(failure_of({"train", "cluster", "--out", ""}, 2),
            "--out: expected a value, got ''; see 'thinbench train cluster --help'");
  EXPECT_EQ(failure_of({"experiment", "quantisation", "--out", ""}, 2),
            "--out: expected a value, got ''; see 'thinbench experiment quantisation --help'");
}

TEST(Program, numbers_out_of_range_are_rejected_with_the_range) {
  const std::string see = "; see 'thinbench run --help'";
  for (const std::string value : {"256", "-1", "x", "1.5", "0x10", ""}) {
    EXPECT_EQ(run_failure({"--threshold=" + value}).find("--threshold"), 0U);
    EXPECT_EQ(run_failure({"--threshold", value}),
              "--threshold: expected an integer in [0, 255] or 'otsu', got '" + value + "'" + see);
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
          {"holes", "absent.png"},
          {"verify", "--image", "absent.png"},
          {"instructions", "--image", "absent.png"},
          {"experiment", "quality", "--image", "absent.png"}};
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
              "--threshold: expected an integer in [0, 255] or 'otsu', got 'high'");
    EXPECT_EQ(failure("--threshold", "256"),
              "--threshold: expected an integer in [0, 255] or 'otsu', got '256'");
    EXPECT_EQ(failure("--invert", "x"), "there is no option '--invert'") << command.front();
  }
}

TEST(Program, options_of_images_require_an_image_where_the_scene_is_the_default) {
  for (const Words& command :
       {Words{"verify"}, Words{"instructions"}, Words{"experiment", "quality"}}) {
    for (const Words& option : {Words{"--foreground", "dark"}, Words{"--threshold", "9"}}) {
      Words words = command;
      words.insert(words.end(), option.begin(), option.end());
      EXPECT_EQ(failure_of(words, 2).find(option.front() + " requires --image; see '"), 0U)
          << failure_of(words, 2);
    }
  }
}

TEST(Program, every_command_rejects_a_malformed_cap) {
  const IsaCap cap("sse9");
  const std::string text = "THINBENCH_MAX_ISA: expected one of " + all_isa_names() + ", got 'sse9'";
  int tested = 0;
  for (Words words : all_commands()) {
    if (words.empty() || !commands_below(words).empty()) continue;
    if (words.front() == "run") words.insert(words.end(), {kOperation, "in.png", "out.png"});
    if (words.front() == "batch") words.insert(words.end(), {kOperation, "in", "--out", "out"});
    if (words.front() == "pictures") words.insert(words.end(), {"--out", "pictures"});
    if (words.front() == "holes" || words.front() == "graph") words.emplace_back("in.png");
    if (words.front() == "edges") words.insert(words.end(), {"in.png", "out.png"});
    EXPECT_EQ(failure_of(words, 2), text) << words.front();
    ++tested;
  }
  EXPECT_EQ(tested, 12 + 2 + 7);
  EXPECT_EQ(run_with({"--help"}).status, 0);
}

TEST(Program, fails_if_standard_output_cannot_be_written) {
  std::ostringstream out;
  std::ostringstream err;
  out.setstate(std::ios::badbit);
  EXPECT_EQ(run_program({"list"}, out, err), 1);
  EXPECT_EQ(err.str(), "thinbench: standard output cannot be written\n");
}

TEST(PicturesCommand, writes_inputs_and_results) {
  const TemporaryDirectory directory;
  const std::string out = directory.file("new/pictures");
  const std::string unknown = failure_of({"pictures", "--out", out, "--input", "squares"}, 2);
  EXPECT_EQ(unknown.rfind("input 'squares': expected scene, square_N", 0), 0U) << unknown;
  EXPECT_EQ(run_with({"pictures", "--out", out, "--input", "square_64"}).status, 0);
  for (const char* name : {"square_64", "square_64_grey", "square_64_thin_guo_hall_keep",
                           "square_64_edges_sobel", "square_64_fill_holes"}) {
    EXPECT_EQ(read_grey(out + "/" + name + ".png").width(), 64) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(out + "/square_64_net_two_layer_linear.png"));
  EXPECT_FALSE(std::filesystem::exists(out + "/square_64_holes.png"));
}

}  // namespace
}  // namespace thinbench
