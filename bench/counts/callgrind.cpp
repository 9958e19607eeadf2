#include "counts/callgrind.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "counts/counted_job.hpp"
#include "support/progress.hpp"
#include "support/whole_file.hpp"

namespace thinbench {
namespace {

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Memory that reads like a file and leaves none behind.
int open_in_memory() {
  const int file = memfd_create("counted", MFD_CLOEXEC);
  if (file < 0) throw_errno("no memory to tell valgrind in");
  return file;
}

void fill(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0) throw_errno("valgrind cannot be told");
    done += static_cast<std::size_t>(written);
  }
  if (lseek(file, 0, SEEK_SET) != 0) throw_errno("valgrind cannot be told");
}

/// Options in the environment or the home directory would change counts, or where they go.
[[noreturn]] void become_valgrind(const std::string& program, int input, int output) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // ends with its parent
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execlp("valgrind", "valgrind", "--command-line-only=yes", "--tool=callgrind",
         "--instr-atstart=no", "--collect-atstart=no", "--callgrind-out-file=/dev/null",
         "--vgdb=no", "--log-fd=1", program.c_str(), nullptr);
  _exit(127);
}

}  // namespace

ValgrindProcess::ValgrindProcess(const std::string& program, const std::string& input)
    : said_(open_in_memory()) {
  const int given = open_in_memory();
  fill(given, input);
  process_ = fork();
  if (process_ == 0) become_valgrind(program, given, said_);
  close(given);
  if (process_ < 0) throw_errno("no process for valgrind");
}

ValgrindProcess::~ValgrindProcess() {
  if (process_ > 0) {
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }
  close(said_);
}

std::optional<std::string> ValgrindProcess::line_in_stock() {
  const std::size_t end = stock_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = stock_.substr(0, end);
  stock_.erase(0, end + 1);
  return line;
}

bool ValgrindProcess::has_ended() {
  if (process_ > 0 && waitpid(process_, &wait_status_, WNOHANG) == process_) process_ = -1;
  return process_ < 0;
}

std::optional<std::string> ValgrindProcess::next_line() {
  constexpr std::chrono::milliseconds kPause{20};
  for (;;) {
    if (auto line = line_in_stock()) return line;
    const bool ended = has_ended();  // before reading: what it said last is read, too
    std::array<char, 4096> more{};
    const ssize_t got = pread(said_, more.data(), more.size(), read_);
    if (got < 0) throw_errno("valgrind cannot be heard");
    read_ += got;
    stock_.append(more.data(), static_cast<std::size_t>(got));
    if (got == 0 && ended) return std::nullopt;
    if (got == 0) std::this_thread::sleep_for(kPause);
  }
}

int ValgrindProcess::status() const {
  return WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : 128 + WTERMSIG(wait_status_);
}

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
struct Said {
  std::string version;
  std::string latest;                               // what was said last
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

Said listen(ValgrindProcess& process, std::size_t calls) {
  Said said;
  Progress progress("counting under callgrind", static_cast<double>(calls));
  while (const auto line = process.next_line()) {
    const std::size_t before = said.calls.size();
    said.add(*line);
    if (said.calls.size() > before) progress.advance(1);
  }
  return said;
}

/// The first call was empty: what it counts stands round all others.
void take_counts(const Said& said, const std::vector<const TimedRow*>& rows,
                 CallgrindCounts& counts) {
  if (said.calls.empty() || !said.calls[0]) return;
  for (std::size_t i = 1; i < said.calls.size() && i <= rows.size(); ++i) {
    if (said.calls[i]) counts.instructions[rows[i - 1]] = *said.calls[i] - *said.calls[0];
  }
}

std::string why_not(const Said& said, int status, std::size_t missing) {
  if (status != 0) {
    return "valgrind ended with status " + std::to_string(status) + ": " + said.latest;
  }
  return missing == 0 ? "" : std::to_string(missing) + " rows failed under valgrind";
}

/// Empty where the system does not say where this program is.
std::filesystem::path program_beside() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? self : std::filesystem::path(self).replace_filename(kCountedCallsProgram);
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream directories(path != nullptr ? path : "");
  for (std::string directory; std::getline(directories, directory, ':');) {
    if (access((std::filesystem::path(directory) / program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace

std::string why_no_callgrind() {
  if (!is_installed("valgrind")) return "valgrind is not installed";
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
  if (why_not_.empty()) {
    process_ = std::make_unique<ValgrindProcess>(program_beside(), job_of(rows_));
  }
}

CallgrindCounts CallgrindRun::counts() {
  CallgrindCounts counts;
  counts.use.why_not = why_not_;
  if (!process_) return counts;
  const Said said = listen(*process_, rows_.size());
  take_counts(said, rows_, counts);
  if (!counts.instructions.empty()) counts.use.version = said.version;
  counts.use.why_not = why_not(said, process_->status(), rows_.size() - counts.instructions.size());
  return counts;
}

}  // namespace thinbench
