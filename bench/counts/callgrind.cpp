#include "counts/callgrind.hpp"

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <system_error>
#include <utility>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "counts/counted_job.hpp"
#include "support/progress.hpp"

namespace thinbench {
namespace {

std::string job_of(const std::vector<const TimedRow*>& rows) {
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const TimedRow* row : rows) names.push_back(row->name);
  std::ostringstream job;
  write_job(job, *rows.front()->input, names);
  return std::move(job).str();
}

/// What follows `mark` in the line; none where it is not there.
std::optional<std::string> after(const std::string& line, const char* mark) {
  const std::size_t place = line.find(mark);
  if (place == std::string::npos) return std::nullopt;
  return line.substr(place + std::strlen(mark));
}

/// What valgrind and the program say, line by line.
struct Answer {
  std::string version;
  std::string latest;                               // the last line
  std::optional<std::uint64_t> collected;           // by the process that ends now
  std::vector<std::optional<std::uint64_t>> calls;  // by processes that have ended

  void add(const std::string& line) {
    if (const auto name = after(line, "Using Valgrind-")) {
      version = name->substr(0, name->find(' '));
    }
    if (const auto number = after(line, "Collected : ")) collected = std::stoull(*number);
    if (line == kCallDone) calls.push_back(std::exchange(collected, std::nullopt));
    if (line == kCallFailed) {
      calls.emplace_back();
      collected.reset();
    }
    if (!line.starts_with("==")) latest = line;  // nothing that callgrind sums up
  }
};

/// Options in the environment or the home directory would change counts, or where they go.
std::string command_line(const std::string& program, const std::string& input) {
  return "exec valgrind --command-line-only=yes --tool=callgrind --instr-atstart=no "
         "--collect-atstart=no --callgrind-out-file=/dev/null --vgdb=no --log-fd=1 '" +
         std::regex_replace(program, std::regex("'"), R"('\'')") + "' <" + input + " 2>&1";
}

/// `program` reads `input` from memory that reads like a file and leaves none behind.
std::FILE* start(const std::string& program, const std::string& input) {
  const int file = memfd_create("job", 0);
  if (file < 0) throw_errno("no memory for the input of valgrind");
  const std::string path = "/dev/fd/" + std::to_string(file);
  std::ofstream(path) << input;
  std::FILE* const output = popen(command_line(program, path).c_str(), "r");
  close(file);
  if (output == nullptr) throw_errno("no process for valgrind");
  return output;
}

Answer listen(std::FILE* output, std::size_t calls) {
  Answer answer;
  Progress progress("counting under callgrind", static_cast<double>(calls));
  std::string line;
  for (int next = 0; (next = std::getc(output)) != EOF;) {
    if (next != '\n') {
      line += static_cast<char>(next);
      continue;
    }
    const std::size_t before = answer.calls.size();
    answer.add(line);
    line.clear();
    if (answer.calls.size() > before) progress.advance(1);
  }
  return answer;
}

/// The first call was empty: what it counts surrounds all others.
void take_counts(const Answer& answer, const std::vector<const TimedRow*>& rows,
                 CallgrindCounts& counts) {
  if (answer.calls.empty() || !answer.calls[0]) return;
  for (std::size_t i = 1; i < answer.calls.size() && i <= rows.size(); ++i) {
    if (answer.calls[i]) counts.instructions[rows[i - 1]] = *answer.calls[i] - *answer.calls[0];
  }
}

std::string why_not(const Answer& answer, int status, std::size_t missing) {
  if (status != 0) {
    const int number = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return "valgrind ended with status " + std::to_string(number) + ": " + answer.latest;
  }
  return missing == 0 ? "" : std::to_string(missing) + " rows failed under valgrind";
}

/// Empty where the system does not say where this program is.
std::filesystem::path program_beside() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? self : std::filesystem::path(self).replace_filename(kCountedCallsProgram);
}

}  // namespace

std::string why_no_callgrind() {
  if (std::system("command -v valgrind >/dev/null") != 0) return "valgrind is not installed";
  const std::filesystem::path program = program_beside();
  if (program.empty()) return "/proc/self/exe cannot be read";
  if (std::filesystem::exists(program)) return {};
  return program.string() + " is missing, which is built where valgrind is installed";
}

bool callgrind_knows(const TimedRow& row) {
  return row.variant != nullptr && row.variant->isa < Isa::avx512;
}

CallgrindRun::CallgrindRun(std::vector<const TimedRow*> rows) : rows_(std::move(rows)) {
  if (rows_.empty()) return;
  why_not_ = why_no_callgrind();
  if (why_not_.empty()) output_.reset(start(program_beside(), job_of(rows_)));
}

CallgrindCounts CallgrindRun::counts() {
  CallgrindCounts counts;
  counts.use.why_not = why_not_;
  if (!output_) return counts;
  const Answer answer = listen(output_.get(), rows_.size());
  const int status = pclose(output_.release());
  take_counts(answer, rows_, counts);
  if (!counts.instructions.empty()) counts.use.version = answer.version;
  counts.use.why_not = why_not(answer, status, rows_.size() - counts.instructions.size());
  return counts;
}

}  // namespace thinbench
