// thinbench run on packed files: without a byte image in between, in memory or out of core. PBM and
// raw bits; TIFF is in packed_tiff.hpp.
#pragma once

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/command.hpp"
#include "cli/thinning_run.hpp"
#include "out_of_core/conversion.hpp"

namespace thinbench {

struct PackedOptions {
  std::string raw;  // "WIDTHxHEIGHT"
  std::string bit_order;
  std::string memory;
  bool out_of_core = false;
  bool resume = false;
};

void add_packed_options(CLI::App& app, PackedOptions& options);

/// Whether IN and OUT are packed files: raw bits or PBM.
[[nodiscard]] bool is_packed_run(const PackedOptions& options, const std::string& out);

/// IN and OUT of a run out of core.
struct PackedFiles {
  std::string in;
  std::string out;
  PackedFormat format;
  Conversion conversion;
};

/// What --memory says, in bytes.
[[nodiscard]] Index memory_of(const PackedOptions& options);

/// Thins a file by tiles and prints the summary.
int thin_out_of_core(const PackedOptions& options, const RequestedThinning& thinning,
                     const PackedFiles& files, const Console& console);

/// Thins and prints the summary.
int run_packed(const PackedOptions& options, const RequestedThinning& thinning,
               const ThinningFiles& files, const Console& console);

}  // namespace thinbench
