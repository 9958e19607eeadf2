// The command line of the sweeps.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace thinbench {

struct SweepOptions {
  std::vector<std::string> only;
  std::string filter;
  std::string out;     // journal to begin
  std::string resume;  // or to go on with
  std::string commit = "unknown";
  int rounds = 9;
  int stop_after = 0;  // rounds of every point; 0 for all
  std::uint64_t seed = 1;
  bool quick = false;
};

/// False where help was asked for, and printed. Throws UsageError.
bool parse_options(const std::vector<std::string>& arguments, SweepOptions& options);

}  // namespace thinbench
