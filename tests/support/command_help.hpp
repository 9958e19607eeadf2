// What every program with commands has to say in its help.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/captured_run.hpp"

namespace thinbench {

/// The subcommands that the help of a command lists.
inline Words commands_below(const ProgramInfo& program, Words words) {
  words.emplace_back("--help");
  std::istringstream help(captured_run(program, words).out);
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
inline std::vector<Words> all_commands(const ProgramInfo& program) {
  std::vector<Words> commands = {{}};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    for (const std::string& name : commands_below(program, commands[i])) {
      commands.push_back(commands[i]);
      commands.back().push_back(name);
    }
  }
  return commands;
}

inline void expect_every_help_has_examples(const ProgramInfo& program) {
  for (Words words : all_commands(program)) {
    std::string command = program.name;
    for (const std::string& word : words) command += " " + word;
    words.emplace_back("--help");
    const ProgramRun run = captured_run(program, words);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Usage: " + command), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("Examples:\n  " + command), std::string::npos) << run.out;
  }
}

}  // namespace thinbench
