// The command-line program as a function, so that tests can call it.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace thinbench {

/// Runs the program with the arguments after its name and returns its exit status: 0 where all went
/// well, 2 where it was asked for something that does not exist, 1 for every other failure. A
/// failure is one line on `err`.
int run_program(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

/// The same up to the command itself, which is not run. At least one argument.
int check_arguments(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace thinbench
