// The command line of the timing program.
#pragma once

#include <string>

#include "timing/inputs.hpp"

namespace thinbench {

struct TimingOptions {
  InputChoice inputs;
  std::string filter;
  std::string rows_out;
  std::string pictures_out;
  int repetitions = 15;
  double seconds = 0.03;  // a repetition
  bool quiet = false;
  bool no_peers = false;
  bool highest_level = false;
};

/// Reads the options that are ours, Google Benchmark's taken out before; false where help was asked
/// for, and printed. Throws UsageError.
bool parse_options(int count, char** arguments, TimingOptions& options);

}  // namespace thinbench
