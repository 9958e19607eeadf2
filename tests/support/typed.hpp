// Command lines of a program, typed in a directory of their own, inside the test process.
#pragma once

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "images/image_file.hpp"
#include "support/isa_tests.hpp"
#include "support/own_directory.hpp"

namespace thinbench {

/// typed.hpp of each directory says which it is.
inline const ProgramInfo& program_under_test();

using Words = std::vector<std::string>;

/// The words of a line; '' is an empty word.
inline Words words_of(const std::string& line) {
  std::istringstream text(line);
  Words words;
  for (std::string word; text >> word;) words.push_back(word == "''" ? "" : word);
  return words;
}

struct ProgramRun {
  int status;
  std::string out;
  std::string err;
};

inline ProgramRun typed(const std::string& line) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = run_program(program_under_test(), words_of(line), out, err);
  return {status, out.str(), err.str()};
}

/// What a command prints that must succeed.
inline std::string output_of(const std::string& line) {
  const ProgramRun run = typed(line);
  EXPECT_EQ(run.status, 0) << line << ": " << run.err;
  return run.out;
}

inline void expect_holds(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in:\n" << text;
}

inline void expect_begins(const std::string& text, const std::string& part) {
  EXPECT_EQ(text.substr(0, part.size()), part) << text;
}

/// A command that must fail with one line that holds these parts, print nothing and leave no file.
struct Rejection {
  int status;  // 1: what the words name cannot be done; 2: the words are wrong
  std::string line;
  std::vector<std::string> parts;
};

inline void expect_rejected(const Rejection& rejection) {
  SCOPED_TRACE(rejection.line);
  const auto files = [] {
    const fs::recursive_directory_iterator all(".");
    return std::set<fs::path>(begin(all), end(all));
  };
  const std::set<fs::path> before = files();
  const ProgramRun run = typed(rejection.line);
  EXPECT_EQ(run.status, rejection.status);
  EXPECT_EQ(run.out, "");
  expect_begins(run.err, program_under_test().name + ": ");
  EXPECT_EQ(run.err.find('\n') + 1, run.err.size()) << run.err;
  for (const std::string& part : rejection.parts) expect_holds(run.err, part);
  EXPECT_EQ(files(), before);
}

inline void expect_rejected(const std::vector<Rejection>& rejections) {
  for (const Rejection& rejection : rejections) expect_rejected(rejection);
}

class Commands : public OwnDirectory {
 protected:
  static void expect_image(const std::string& file, const ByteImage& expected) {
    EXPECT_TRUE(equal(read_grey(file).view(), expected.view())) << file;
  }
};

/// The subcommands that the help of a command lists.
inline Words commands_below(const std::string& command) {
  std::istringstream help(typed(command + " --help").out);
  Words found;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (listed && line.rfind("  ", 0) == 0 && line[2] != ' ') {
      found.push_back(command + " " + line.substr(2, line.find(' ', 2) - 2));
    }
    listed = (listed && line.rfind("  ", 0) == 0) || line == "Subcommands:";
  }
  return found;
}

/// Of so many commands, the program itself among them.
inline void expect_every_help_has_examples(std::size_t count) {
  Words commands = {""};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    for (const std::string& below : commands_below(commands[i])) commands.push_back(below);
    const std::string command = program_under_test().name + commands[i];
    const ProgramRun run = typed(commands[i] + " --help");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    expect_holds(run.out, "Usage: " + command);
    expect_holds(run.out, "Examples:\n  " + command);
  }
  EXPECT_EQ(commands.size(), count);
}

}  // namespace thinbench
