// A program with commands as a function, so that tests can call it.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace thinbench {

struct Command;

/// What a program is called, what its help says, and its commands, in the order of the help.
struct ProgramInfo {
  std::string name;
  std::string description;
  std::string footer;
  std::vector<Command (*)(CLI::App& app)> commands;
};

/// Runs the program with the arguments after its name and returns its exit status: 0 where all went
/// well, 2 where it was asked for something that does not exist, 3 where there is no path, 1 for
/// every other failure. A failure is one line on `err`.
int run_program(const ProgramInfo& program, const std::vector<std::string>& args, std::ostream& out,
                std::ostream& err);

/// The same on the standard streams. Signals remove unfinished files.
int run_main(const ProgramInfo& program, int argc, char** argv);

/// As run_program() up to the command itself, which is not run. At least one argument.
int check_arguments(const ProgramInfo& program, const std::vector<std::string>& args,
                    std::ostream& out, std::ostream& err);

}  // namespace thinbench
