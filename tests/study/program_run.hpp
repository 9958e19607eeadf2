// The program `thinbench-study` inside the test process.
#pragma once

#include "study/study.hpp"
#include "support/captured_run.hpp"

namespace thinbench {

inline ProgramRun run_with(const std::vector<std::string>& args) {
  return captured_run(study_program(), args);
}

/// See captured_failure().
inline std::string failure_of(const std::vector<std::string>& args, int status) {
  return captured_failure(study_program(), args, status);
}

}  // namespace thinbench
