// The program `thinbench` inside the test process.
#pragma once

#include "cli/thinbench.hpp"
#include "support/captured_run.hpp"

namespace thinbench {

inline ProgramRun run_with(const std::vector<std::string>& args) {
  return captured_run(thinbench_program(), args);
}

/// See captured_failure().
inline std::string failure_of(const std::vector<std::string>& args, int status) {
  return captured_failure(thinbench_program(), args, status);
}

}  // namespace thinbench
