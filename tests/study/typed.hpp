// Command lines of `thinbench-study`.
#pragma once

#include "study/study.hpp"
#include "support/typed.hpp"

namespace thinbench {

inline const ProgramInfo& program_under_test() {
  return study_program();
}

}  // namespace thinbench
