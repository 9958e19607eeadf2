#include "counts/valgrind_process.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// Options in the environment or the home folder would change counts, or where they go.
[[noreturn]] void become_valgrind(const std::string& program, int input, int output) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // nobody listens when its parent has ended
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

}  // namespace thinbench
