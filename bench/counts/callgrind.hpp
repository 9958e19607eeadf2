// Instructions counted by valgrind's callgrind, which runs a program on a processor of its own: a
// hundred times as fast as single steps, but without AVX-512.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "measure/timed_row.hpp"

namespace thinbench {

struct CallgrindUse {
  std::string version;  // of valgrind; empty where it counted nothing
  std::string why_not;  // what kept rows from being counted; empty where all were
};

struct CallgrindCounts {
  std::map<const TimedRow*, std::uint64_t> instructions;  // of one call
  CallgrindUse use;
};

/// Whether valgrind knows the instructions of the row's ISA.
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
  struct Close {
    void operator()(std::FILE* output) const { pclose(output); }
  };
  std::unique_ptr<std::FILE, Close> output_;  // of valgrind; none where there is nothing to run
};

}  // namespace thinbench
