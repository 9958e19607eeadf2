// The program that callgrind runs: reads a job from standard input and calls each of its rows in a
// process of its own, with callgrind's counters on around one warm call. Callgrind says at the end
// of each process what it counted. It links no more than the rows, because all of it starts slowly.
#include <exception>
#include <iostream>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>
#include <valgrind/callgrind.h>

#include "counts/counted_job.hpp"

namespace thinbench {
namespace {

/// Not inlined, so that what surrounds the call is the same for every row. Instrumentation is
/// for the whole process, collecting for this thread: another one may just be on its way to wait.
[[gnu::noinline]] void count(const CountedCall& call) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_TOGGLE_COLLECT;
  call();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_STOP_INSTRUMENTATION;
}

void call_row(const std::string& name, const TimedInput& input) {
  const TimedRow row = row_named(name, all_operations(), {&input, 1});
  if (!row.variant->unavailable_reason(input.width()).empty()) {
    throw std::runtime_error("valgrind lacks what '" + name + "' needs");
  }
  with_warm_call(row, count);
}

/// Callgrind writes its line before the process has ended, and then comes ours.
template <class Call>
void in_a_process(const Call& call) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      call();
      _exit(0);
    } catch (const std::exception&) {
      _exit(1);
    }
  }
  int status = 1;
  if (child > 0) waitpid(child, &status, 0);
  std::cout << (status == 0 ? kCallDone : kCallFailed) << std::endl;
}

int run() {
  std::ios::sync_with_stdio(false);
  const CountedJob job = read_job(std::cin);
  static_cast<void>(all_operations());  // made once, not in every process
  in_a_process([] { count([] {}); });
  for (const std::string& row : job.rows) in_a_process([&] { call_row(row, job.input); });
  return 0;
}

}  // namespace
}  // namespace thinbench

int main() {
  try {
    return thinbench::run();
  } catch (const std::exception& error) {
    std::cerr << thinbench::kCountedCallsProgram << ": " << error.what() << '\n';
    return 1;
  }
}
