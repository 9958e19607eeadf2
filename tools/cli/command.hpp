// A command of a program: it declares its arguments and has the function that runs it.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/usage.hpp"

namespace thinbench {

struct Console {
  std::ostream& out;
  std::ostream& err;
};

/// Where a line about an image that was written goes: not where the image went.
[[nodiscard]] inline std::ostream& summary_stream(const Console& console, const std::string& out) {
  return out == "-" ? console.err : console.out;
}

struct Command {
  CLI::App* app;
  std::function<int(const Console&)> run;  // after parsing
  std::vector<Command> parts = {};         // of a command that only holds others and has no `run`
};

}  // namespace thinbench
