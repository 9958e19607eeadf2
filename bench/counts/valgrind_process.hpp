// A program that runs under valgrind's callgrind, and the lines that both say.
#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include <sys/types.h>

namespace thinbench {

/// The status of a process that found no valgrind to become.
inline constexpr int kNoValgrind = 127;

/// Instrumentation is off at the start, and no files are written. Throws std::system_error where
/// the system gives no process, pipe or memory.
class ValgrindProcess {
 public:
  /// `program` reads `input` from standard input.
  ValgrindProcess(const std::string& program, const std::string& input);
  /// Waits for the process, which nobody listens to any more.
  ~ValgrindProcess();
  ValgrindProcess(const ValgrindProcess&) = delete;
  ValgrindProcess& operator=(const ValgrindProcess&) = delete;
  ValgrindProcess(ValgrindProcess&&) = delete;
  ValgrindProcess& operator=(ValgrindProcess&&) = delete;

  /// None at the end.
  [[nodiscard]] std::optional<std::string> next_line();

  /// Waits for the end; 128 and the number of the signal where one ended it.
  [[nodiscard]] int status();

 private:
  std::FILE* lines_ = nullptr;
  pid_t process_ = -1;
};

}  // namespace thinbench
