// thinbench run on packed files: without a byte image in between. PBM and raw bits; TIFF is in
// packed_tiff.hpp.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/command.hpp"
#include "cli/thinning_run.hpp"

namespace thinbench {

struct PackedOptions {
  std::string raw;  // "WIDTHxHEIGHT"
  std::string bit_order;
};

void add_packed_options(CLI::App& app, PackedOptions& options);

/// Whether IN and OUT are packed files: raw bits or PBM.
[[nodiscard]] bool is_packed_run(const PackedOptions& options, const std::string& out);

/// Thins and prints the summary.
int run_packed(const PackedOptions& options, const RequestedThinning& thinning, FileBytes in,
               const std::string& out, const Console& console);

}  // namespace thinbench
