// Arguments of both programs, one per line, up to the command itself: status 0 or 2, and then one
// line that says what is wrong.
#include <sstream>

#include "byte_source.hpp"
#include "cli/thinbench.hpp"
#include "study/study.hpp"

namespace thinbench {
namespace {

void check(const ProgramInfo& program, const std::vector<std::string>& words) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = check_arguments(program, words, out, err);
  if (status == 0) return;
  const std::string said = err.str();
  must(status == 2, "status " + std::to_string(status) + ": " + said);
  must(out.str().empty() && said.ends_with('\n'), "no line on standard error alone");
  must_be_one_line(said.substr(0, said.size() - 1));
}

}  // namespace

void try_input(ByteSource& input) {
  std::vector<std::string> words;
  while (!input.is_empty() && words.size() < 12) words.push_back(input.line());
  if (words.empty()) return;
  check(thinbench_program(), words);
  check(study_program(), words);
}

}  // namespace thinbench
