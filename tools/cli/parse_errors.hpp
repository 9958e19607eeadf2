// What is wrong with a command line, in one line.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace thinbench {

/// Names the command that rejected the command line.
[[nodiscard]] std::string parse_error_text(const CLI::ParseError& error, const CLI::App& program);

/// Parses the words after the program's name. False where help was asked for, and printed. Throws
/// UsageError.
[[nodiscard]] bool parse_or_help(CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace thinbench
