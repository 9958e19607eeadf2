// thinbench run on packed files: without a byte image in between, in memory or out of core.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/command.hpp"
#include "cli/thinning_run.hpp"

namespace thinbench {

struct PackedOptions {
  std::string raw;  // "WIDTHxHEIGHT"
  std::string bit_order;
  std::string memory;
  bool out_of_core = false;
  bool resume = false;
};

void add_packed_options(CLI::App& app, PackedOptions& options);

/// Whether IN and OUT are packed files.
[[nodiscard]] bool is_packed_run(const PackedOptions& options, const std::string& out);

/// Thins and prints the summary.
int run_packed(const PackedOptions& options, const detail::ThinningOperation& operation,
               const ThinningFiles& files, const Options& how, const Console& console);

}  // namespace thinbench
