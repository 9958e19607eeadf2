// The command line of the program of paired speed-ups.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "paired/plan.hpp"

namespace thinbench {

/// Cases whose reference takes so many times the limit for a row are omitted, too: big images would
/// take hours.
inline constexpr double kSlowReference = 100;

struct PairedOptions {
  std::vector<std::string> pictures;
  BinariseOptions binarise;
  std::string filter;
  std::string samples_out;
  std::string csv_out;
  int processes = 9;
  std::uint64_t first_seed = 0;
  PlanLimits limits;
  double slowest_ms = 1e9;  // a call
  bool highest_level = false;
  bool no_peers = false;
  bool quiet = false;
  /// Set in a process that measures: it takes its order from standard input.
  std::optional<std::uint64_t> measure_with_seed;
};

/// False where help was asked for, and printed. Throws UsageError.
bool parse_options(const std::vector<std::string>& arguments, PairedOptions& options);

}  // namespace thinbench
