// A program that runs under valgrind's callgrind, and the lines that both say.
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace thinbench {

/// Runs beside this process. Instrumentation and collecting are off at the start, and no files are
/// written. Throws std::system_error where the system gives no process or memory.
class ValgrindProcess {
 public:
  /// `program` reads `input` from standard input.
  ValgrindProcess(const std::string& program, const std::string& input);
  /// Ends what still runs.
  ~ValgrindProcess();
  ValgrindProcess(const ValgrindProcess&) = delete;
  ValgrindProcess& operator=(const ValgrindProcess&) = delete;
  ValgrindProcess(ValgrindProcess&&) = delete;
  ValgrindProcess& operator=(ValgrindProcess&&) = delete;

  /// Waits for the next line that both say; none at the end.
  [[nodiscard]] std::optional<std::string> next_line();

  /// Once there are no more lines: as shells have it, 127 without valgrind, 128 and the number of
  /// the signal where one ended the process.
  [[nodiscard]] int status() const;

 private:
  [[nodiscard]] std::optional<std::string> line_in_stock();
  [[nodiscard]] bool has_ended();

  int said_ = -1;       // memory that it writes to, so that it never waits for a reader
  std::string stock_;   // read and not yet given out
  off_t read_ = 0;      // bytes of what it said
  pid_t process_ = -1;  // -1 after its end
  int wait_status_ = 0;
};

}  // namespace thinbench
