#include "paired/child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace thinbench {
namespace {

struct FileClose {
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using File = std::unique_ptr<std::FILE, FileClose>;

[[noreturn]] void throw_code(int code, const char* what) {
  throw std::system_error(code, std::generic_category(), what);
}

/// Both ends are closed in every program that is started, unless made its input or output.
std::array<int, 2> new_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_code(errno, "no pipe");
  return ends;
}

class Process {
 public:
  explicit Process(const std::string& seed) {
    const auto [order_read, order_write] = new_pipe();
    const auto [answer_read, answer_write] = new_pipe();
    std::array<std::string, 3> words = {"thinbench_paired", "--measure-with-seed", seed};
    std::array<char*, 4> arguments = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, order_read, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, answer_write, STDOUT_FILENO);
    const int code =
        posix_spawn(&id_, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(order_read);
    close(answer_write);
    order_.reset(fdopen(order_write, "w"));
    answer_.reset(fdopen(answer_read, "r"));
    if (code != 0) throw_code(code, "cannot start a process that measures");
  }
  ~Process() {
    order_.reset();
    answer_.reset();
    if (id_ > 0) waitpid(id_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  Process(Process&&) = delete;
  Process& operator=(Process&&) = delete;

  void give(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), order_.get());
    order_.reset();
  }

  void pass_on_lines(const LineSink& sink) {
    char* line = nullptr;
    std::size_t room = 0;
    while (getline(&line, &room, answer_.get()) > 0) {
      const std::unique_ptr<char, decltype(&std::free)> owner(line, &std::free);
      sink(line);
      line = nullptr;
      room = 0;
    }
    std::free(line);
  }

  /// True where it ended as it should.
  bool ended_well() {
    int status = 0;
    const pid_t ended = waitpid(id_, &status, 0);
    id_ = 0;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  pid_t id_ = 0;
  File order_;
  File answer_;
};

}  // namespace

void measure_in_new_process(const std::string& order, std::uint64_t seed, const LineSink& answer) {
  std::signal(SIGPIPE, SIG_IGN);  // a process that ended early shows in its status
  Process process(std::to_string(seed));
  process.give(order);
  process.pass_on_lines(answer);
  if (!process.ended_well()) throw std::runtime_error("a process that measures failed");
}

}  // namespace thinbench
