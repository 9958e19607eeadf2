// What is wrong with a command line, in one line.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace thinbench {

/// `app` is the command that was being parsed, or the program itself.
[[nodiscard]] std::string parse_error_text(const CLI::ParseError& error, const CLI::App& app);

}  // namespace thinbench
