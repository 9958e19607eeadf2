// The command line of the gate.
#pragma once

#include <string>
#include <vector>

namespace thinbench {

struct RegressOptions {
  std::vector<std::string> run;  // samples, as those below
  std::vector<std::string> again;
  std::vector<std::string> old;  // of the build to compare with, measured by turns with `run`
  std::vector<std::string> old_again;
  std::string baselines;  // a folder; files are named after fingerprints
  std::string rerun_out;
  std::string reason;
  std::string commit = "unknown";
  bool update = false;
  bool counts_file = false;  // only print where counts of instructions belong
  bool judge_threads = false;
  bool all = false;
};

/// False where help was asked for, and printed. Throws UsageError.
bool parse_options(const std::vector<std::string>& arguments, RegressOptions& options);

}  // namespace thinbench
