// What the program that callgrind runs is told and what it answers, plain text and pixels; and the
// call that is counted, made ready alike for every way to count.
#pragma once

#include <cerrno>
#include <exception>
#include <functional>
#include <istream>
#include <ostream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <malloc.h>

#include "measure/timed_call.hpp"
#include "measure/timed_row.hpp"

namespace thinbench {

/// Stands beside every program that counts, where it was built.
inline constexpr const char* kCountedCallsProgram = "thinbench_counted_calls";

/// Answers, a line for each process: first an empty call, then the rows.
inline constexpr const char* kCallDone = "call done";
inline constexpr const char* kCallFailed = "call failed";

/// Throws std::system_error by errno.
[[noreturn]] inline void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

struct CountedJob {
  TimedInput input;
  std::vector<std::string> rows;  // case/technique/isa/threads/scope/input
};

void write_job(std::ostream& stream, const TimedInput& input, const std::vector<std::string>& rows);

/// Throws std::runtime_error where the stream holds less than a job.
[[nodiscard]] CountedJob read_job(std::istream& stream);

using CountedCall = std::function<void()>;

/// Makes the row ready, calls it once and hands the next call to `count`. All in a thread of its
/// own, which gets unused memory, with copies of the input there, too: the C
/// library's copies take another path where addresses differ, by a few instructions. For processes
/// that end after it. Throws what the row throws.
template <class Count>
void with_warm_call(const TimedRow& row, const Count& count) {
  mallopt(M_MMAP_THRESHOLD, 1 << 17);  // as it is at first; it would grow with what was freed
  std::exception_ptr failure;
  std::thread([&] {
    try {
      const ByteImage input = copy_of(row.input->view(*row.operation));
      ByteImage output(input.width(), input.height());
      TimedCall call(row, input.view(), output.view());
      call();
      count([&call] { call(); });
    } catch (...) {
      failure = std::current_exception();
    }
  }).join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace thinbench
