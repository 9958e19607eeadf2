// What is wrong with a command line, in one line.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace thinbench {

/// `app` is the command that was being parsed, or the program itself.
[[nodiscard]] std::string parse_error_text(const CLI::ParseError& error, const CLI::App& app);

/// Parses the words after the program's name. False where help was asked for, and printed. Throws
/// UsageError.
[[nodiscard]] bool parse_or_help(CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace thinbench
