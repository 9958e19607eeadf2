// --foreground and --threshold, the same for every command that reads images.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "picture/binarise.hpp"

namespace thinbench {

/// `image` is the option without which these have no meaning; nullptr where the command always
/// reads an image.
void add_binarise_options(CLI::App& app, BinariseOptions& options, CLI::Option* image = nullptr);

/// The options that were given, each with a space before it: " --foreground dark".
[[nodiscard]] std::string binarise_words(const BinariseOptions& options);

}  // namespace thinbench
