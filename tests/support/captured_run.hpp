// Runs a program inside the test process and captures its output.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "support/isa_cap.hpp"

namespace thinbench {

using Words = std::vector<std::string>;

/// The words of a line; '' is an empty word.
inline Words words_of(const std::string& line) {
  std::istringstream text(line);
  Words words;
  for (std::string word; text >> word;) words.push_back(word == "''" ? "" : word);
  return words;
}

struct ProgramRun {
  int status;
  std::string out;
  std::string err;
};

inline ProgramRun captured_run(const ProgramInfo& program, const std::vector<std::string>& args) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = run_program(program, args, out, err);
  return {status, out.str(), err.str()};
}

/// The error message of a run that must fail with this status, with one line on standard error and
/// nothing on standard output; otherwise a description of the run.
inline std::string captured_failure(const ProgramInfo& program,
                                    const std::vector<std::string>& args, int status) {
  const ProgramRun run = captured_run(program, args);
  const std::string lead_in = program.name + ": ";
  const bool is_one_line =
      run.err.rfind(lead_in, 0) == 0 && run.err.find('\n') + 1 == run.err.size();
  if (run.status != status || !run.out.empty() || !is_one_line) {
    return "status " + std::to_string(run.status) + ", out: " + run.out + ", err: " + run.err;
  }
  return run.err.substr(lead_in.size(), run.err.size() - lead_in.size() - 1);
}

}  // namespace thinbench
