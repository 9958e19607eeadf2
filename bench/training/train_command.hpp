// `thinbench train`: the command line of the training.
#pragma once

#include <iosfwd>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is not ours
class App;
}

namespace thinbench {

/// Adds the command `train` with `two-layer` and `cluster`. They run when the program's line is
/// parsed, print on `out`, and throw std::runtime_error or std::invalid_argument with one line.
void add_train_command(CLI::App& program, std::ostream& out, std::ostream& err);

}  // namespace thinbench
