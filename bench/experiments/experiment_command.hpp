// `thinbench experiment`: the command line of the experiments.
#pragma once

#include <iosfwd>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is not ours
class App;
}

namespace thinbench {

/// Adds the command `experiment` with one subcommand an experiment. They run when the program's
/// line is parsed, print Markdown on `out` and progress on `err`, and throw std::runtime_error with
/// one line.
void add_experiment_command(CLI::App& program, std::ostream& out, std::ostream& err);

}  // namespace thinbench
