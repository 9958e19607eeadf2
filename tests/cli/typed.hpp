// Command lines of `thinbench`.
#pragma once

#include "cli/thinbench.hpp"
#include "support/typed.hpp"

namespace thinbench {

inline const ProgramInfo& program_under_test() {
  return thinbench_program();
}

}  // namespace thinbench
