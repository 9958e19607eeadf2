// The call that is counted, made ready alike for every way to count.
#pragma once

#include <exception>
#include <functional>
#include <thread>

#include <malloc.h>

#include "measure/timed_call.hpp"

namespace thinbench {

using CountedCall = std::function<void()>;

/// Makes the row ready, calls it once and hands the next call to `count`. All in a thread of its
/// own, which gets memory that nobody used before, with copies of the input there, too: the C
/// library's copies take another path where addresses differ, by a few instructions. For processes
/// that end after it. Throws what the row throws.
template <class Count>
void with_warm_call(const TimedRow& row, const Count& count) {
  mallopt(M_MMAP_THRESHOLD, 1 << 17);  // as it is at first; it would grow with what was freed
  std::exception_ptr failure;
  std::thread([&] {
    try {
      const ByteImage input = copy_of(row.input->view(row.operation->takes));
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
