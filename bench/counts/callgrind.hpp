// Instructions counted by valgrind's callgrind, which runs a program on a processor of its own: a
// hundred times as fast as single steps, but without AVX-512.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "measure/timed_row.hpp"

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

struct CallgrindUse {
  std::string version;  // of valgrind; empty where it counted nothing
  std::string why_not;  // what kept rows from being counted; empty where all were
};

struct CallgrindCounts {
  std::map<const TimedRow*, std::uint64_t> instructions;  // of one call
  CallgrindUse use;

  [[nodiscard]] std::optional<std::uint64_t> of(const TimedRow& row) const {
    const auto found = instructions.find(&row);
    if (found == instructions.end()) return std::nullopt;
    return found->second;
  }
};

/// Whether valgrind knows the instructions of the row's level.
[[nodiscard]] bool callgrind_knows(const TimedRow& row);

/// Why callgrind can count nothing here; empty where it can.
[[nodiscard]] std::string why_no_callgrind();

/// Calls rows of one input under one valgrind that runs beside this process, each in a process of
/// its own that has called it once before. Leaves no files behind. What cannot be counted is left
/// out: everything where valgrind or the program that it runs is missing.
class CallgrindRun {
 public:
  /// The rows outlive the run and its counts. Throws std::system_error where the system gives no
  /// process.
  explicit CallgrindRun(std::vector<const TimedRow*> rows);

  /// Waits for the end; once.
  [[nodiscard]] CallgrindCounts counts();

 private:
  std::vector<const TimedRow*> rows_;
  std::string why_not_;
  std::unique_ptr<ValgrindProcess> process_;  // none where there is nothing to run
};

}  // namespace thinbench
