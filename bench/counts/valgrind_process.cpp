#include "counts/valgrind_process.hpp"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace thinbench {
namespace {

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// A descriptor that is closed where it leaves its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Memory that reads like a file: nobody waits for who reads, and nothing is left behind.
int open_in_memory() {
  const int file = memfd_create("counted", MFD_CLOEXEC);
  if (file < 0) throw_errno("no memory to hand over what is counted");
  return file;
}

void fill(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0) throw_errno("what is counted cannot be handed over");
    done += static_cast<std::size_t>(written);
  }
  if (lseek(file, 0, SEEK_SET) != 0) throw_errno("what is counted cannot be handed over");
}

/// Options in the environment or the home folder would change counts, or where they go.
[[noreturn]] void become_valgrind(const std::string& program, int input, int output) {
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execlp("valgrind", "valgrind", "--command-line-only=yes", "--tool=callgrind",
         "--instr-atstart=no", "--callgrind-out-file=/dev/null", "--log-fd=1", program.c_str(),
         nullptr);
  _exit(kNoValgrind);
}

}  // namespace

ValgrindProcess::ValgrindProcess(const std::string& program, const std::string& input) {
  const Descriptor given(open_in_memory());
  fill(given.number(), input);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_errno("no pipe");
  const Descriptor said(ends[1]);
  lines_ = fdopen(ends[0], "r");
  process_ = fork();
  if (process_ == 0) become_valgrind(program, given.number(), said.number());
  if (process_ < 0) {
    std::fclose(lines_);
    throw_errno("no process for valgrind");
  }
}

ValgrindProcess::~ValgrindProcess() {
  std::fclose(lines_);
  if (process_ > 0) waitpid(process_, nullptr, 0);
}

std::optional<std::string> ValgrindProcess::next_line() {
  std::string line;
  int character = 0;
  while ((character = std::fgetc(lines_)) != EOF && character != '\n') {
    line += static_cast<char>(character);
  }
  if (character == EOF && line.empty()) return std::nullopt;
  return line;
}

int ValgrindProcess::status() {
  int status = 0;
  waitpid(std::exchange(process_, -1), &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace thinbench
