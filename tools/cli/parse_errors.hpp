// What is wrong with a command line, in one line.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace thinbench {

/// Parses the words after the program's name. False where help or the version was asked for, and
/// printed. Throws UsageError, which names the command that rejected the words.
[[nodiscard]] bool parse_or_help(CLI::App& app, const std::vector<std::string>& arguments,
                                 std::ostream& out);

}  // namespace thinbench
