// Runs the program within the test and keeps what it said.
#pragma once

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "thinbench/isa.hpp"

namespace thinbench {

struct ProgramRun {
  int status;
  std::string out;
  std::string err;
};

inline ProgramRun run_with(const std::vector<std::string>& args) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = run_program(args, out, err);
  return {status, out.str(), err.str()};
}

/// The text of a failure with this status: one line on standard error, nothing on the other.
inline std::string failure_of(const std::vector<std::string>& args, int status) {
  const ProgramRun run = run_with(args);
  const std::string lead_in = "thinbench: ";
  const bool is_one_line =
      run.err.rfind(lead_in, 0) == 0 && run.err.find('\n') + 1 == run.err.size();
  if (run.status != status || !run.out.empty() || !is_one_line) {
    return "status " + std::to_string(run.status) + ", out: " + run.out + ", err: " + run.err;
  }
  return run.err.substr(lead_in.size(), run.err.size() - lead_in.size() - 1);
}

/// Sets the cap on the instruction set while it lives.
class IsaCap {
 public:
  explicit IsaCap(const char* cap) {
    if (const char* old = std::getenv(kIsaCapVariable)) old_ = old;
    setenv(kIsaCapVariable, cap, 1);
  }
  ~IsaCap() { old_ ? setenv(kIsaCapVariable, old_->c_str(), 1) : unsetenv(kIsaCapVariable); }
  IsaCap(const IsaCap&) = delete;
  IsaCap& operator=(const IsaCap&) = delete;
  IsaCap(IsaCap&&) = delete;
  IsaCap& operator=(IsaCap&&) = delete;

 private:
  std::optional<std::string> old_;
};

}  // namespace thinbench
